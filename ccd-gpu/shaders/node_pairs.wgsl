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
    var phi_854_: type_9;
    var phi_857_: u32;
    var phi_855_: type_9;
    var phi_880_: type_9;
    var phi_903_: bool;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_910_: bool;
    var phi_918_: bool;
    var phi_926_: u32;
    var phi_858_: u32;
    var phi_927_: u32;
    var phi_937_: type_9;
    var phi_963_: u32;
    var phi_966_: type_9;
    var phi_969_: type_9;
    var phi_967_: type_9;
    var phi_992_: type_9;
    var phi_1009_: type_9;
    var phi_1012_: type_9;
    var phi_1013_: type_9;
    var phi_1035_: type_9;
    var phi_1069_: type_9;
    var phi_1070_: bool;
    var phi_1010_: type_9;
    var phi_1071_: bool;
    var phi_1079_: u32;
    var phi_1116_: type_9;
    var phi_1117_: type_9;
    var phi_1140_: type_9;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_970_: type_9;
    var local_1: u32;
    var local_2: u32;
    var local_3: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e38 = id_2;
    let _e39 = n_2;
    let _e40 = lane_2;
    let _e49 = ((_e38.y * _e39.x) + _e38.x);
    let _e52 = (_e39.x * _e39.y);
    let _e55 = params.member.member_1.member_2;
    let _e57 = input.member[0u];
    if (_e55 < _e57) {
        phi_156_ = _e55;
    } else {
        phi_156_ = _e57;
    }
    let _e60 = phi_156_;
    let _e61 = (_e40 / 32u);
    let _e65 = params.member.member_1.member_1;
    if (_e60 > _e65) {
        let _e69 = params.member.member_1.member_1;
        let _e70 = (_e60 - _e69);
        let _e73 = params.member.member_2.member_3;
        if (_e73 == 0u) {
            return;
        }
        let _e75 = (_e70 / _e73);
        if (_e73 == 0u) {
            return;
        }
        if ((_e70 % _e73) > 0u) {
            phi_193_ = (_e75 + 1u);
        } else {
            phi_193_ = _e75;
        }
        let _e81 = phi_193_;
        phi_194_ = _e81;
    } else {
        phi_194_ = 0u;
    }
    let _e83 = phi_194_;
    let _e86 = params.member.member_2.member_4;
    if (_e86 < _e83) {
        phi_202_ = _e86;
    } else {
        phi_202_ = _e83;
    }
    let _e89 = phi_202_;
    let _e90 = (_e89 / 4u);
    if ((_e89 % 4u) > 0u) {
        phi_218_ = (_e90 + 1u);
    } else {
        phi_218_ = _e90;
    }
    let _e95 = phi_218_;
    if (_e95 > _e49) {
        let _e97 = (_e95 - _e49);
        if (_e52 == 0u) {
            return;
        }
        let _e99 = (_e97 / _e52);
        if (_e52 == 0u) {
            return;
        }
        if ((_e97 % _e52) > 0u) {
            phi_241_ = (_e99 + 1u);
        } else {
            phi_241_ = _e99;
        }
        let _e105 = phi_241_;
        phi_242_ = _e105;
    } else {
        phi_242_ = 0u;
    }
    let _e107 = phi_242_;
    phi_245_ = type_9(0u, _e107);
    loop {
        let _e110 = phi_245_;
        if (_e110.member < _e110.member_1) {
            phi_246_ = type_9((_e110.member + 1u), _e110.member_1);
            phi_269_ = type_9(1u, _e110.member);
        } else {
            phi_246_ = _e110;
            phi_269_ = type_9(0u, type_9().member_1);
        }
        let _e122 = phi_246_;
        let _e124 = phi_269_;
        let _e128 = (bitcast<i32>(_e124.member) != 0i);
        if _e128 {
            let _e133 = (((_e49 + (_e124.member_1 * _e52)) * 4u) + (_e40 / 32u));
            let _e136 = params.member.member_1.member_1;
            if (_e60 > _e136) {
                let _e140 = params.member.member_1.member_1;
                let _e141 = (_e60 - _e140);
                let _e144 = params.member.member_2.member_3;
                if (_e144 == 0u) {
                    return;
                }
                let _e146 = (_e141 / _e144);
                if (_e144 == 0u) {
                    return;
                }
                if ((_e141 % _e144) > 0u) {
                    phi_316_ = (_e146 + 1u);
                } else {
                    phi_316_ = _e146;
                }
                let _e152 = phi_316_;
                phi_317_ = _e152;
            } else {
                phi_317_ = 0u;
            }
            let _e154 = phi_317_;
            let _e157 = params.member.member_2.member_4;
            if (_e157 < _e154) {
                phi_325_ = _e157;
            } else {
                phi_325_ = _e154;
            }
            let _e160 = phi_325_;
            let _e161 = (_e133 < _e160);
            let _e164 = params.member.member_1.member_1;
            let _e167 = params.member.member_2.member_3;
            if _e161 {
                phi_339_ = (_e133 * _e167);
            } else {
                phi_339_ = 0u;
            }
            let _e170 = phi_339_;
            let _e172 = (2u * (_e164 + _e170));
            let _e175 = input.member[(4u + _e172)];
            let _e178 = input.member[(_e172 + 5u)];
            if (_e40 <= 7u) {
                atomicStore((&counters[_e40]), 0u);
            }
            workgroupBarrier();
            if ((_e40 % 32u) == 0u) {
                firsts[(2u * _e61)] = (_e175 * 32u);
                firsts[((2u * _e61) + 1u)] = (_e178 * 32u);
            }
            let _e191 = params.member.member_2.member_1;
            if (_e191 == 0u) {
                phi_399_ = array<u32, 2>(0u, 2u);
            } else {
                phi_399_ = array<u32, 2>(1u, 1u);
            }
            let _e194 = phi_399_;
            let _e197 = (_e40 / 32u);
            let _e198 = (_e40 % 32u);
            let _e200 = params.member.member_2.member_2;
            let _e204 = params.member.member_2.member[_e200][_e194[0]];
            let _e207 = nodes.member[(_e204 + _e175)];
            let _e221 = params.member.member_2.member_2;
            let _e225 = params.member.member_2.member[_e221][_e194[1]];
            let _e228 = nodes.member[(_e225 + _e178)];
            let _e242 = params.member.member_2.member_2;
            let _e249 = params.member.member_2.member[(_e242 - 1u)][_e194[0]];
            let _e252 = nodes.member[(_e249 + ((_e175 * 32u) + _e198))];
            let _e269 = params.member.member_2.member_2;
            let _e276 = params.member.member_2.member[(_e269 - 1u)][_e194[1]];
            let _e279 = nodes.member[(_e276 + ((_e178 * 32u) + _e198))];
            if _e161 {
                phi_560_ = ((((((_e252.member.x <= _e228.member_1.y) && (_e228.member.x <= _e252.member_1.y)) && (_e252.member.y <= _e228.member_2.x)) && (_e228.member.y <= _e252.member_2.x)) && (_e252.member_1.x <= _e228.member_2.y)) && (_e228.member_1.x <= _e252.member_2.y));
            } else {
                phi_560_ = false;
            }
            let _e304 = phi_560_;
            if _e161 {
                if ((((((_e279.member.x <= _e207.member_1.y) && (_e207.member.x <= _e279.member_1.y)) && (_e279.member.y <= _e207.member_2.x)) && (_e207.member.y <= _e279.member_2.x)) && (_e279.member_1.x <= _e207.member_2.y)) && (_e207.member_1.x <= _e279.member_2.y)) {
                    let _e318 = atomicAdd((&counters[_e197]), 1u);
                    let _e319 = ((_e197 * 32u) + _e318);
                    columns[_e319] = type_24(array<f32, 3>(_e279.member.x, _e279.member.y, _e279.member_1.x), array<f32, 3>(_e279.member_1.y, _e279.member_2.x, _e279.member_2.y));
                    names[_e319] = _e198;
                }
            }
            if _e304 {
                phi_598_ = type_24(array<f32, 3>(_e252.member.x, _e252.member.y, _e252.member_1.x), array<f32, 3>(_e252.member_1.y, _e252.member_2.x, _e252.member_2.y));
            } else {
                phi_598_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e326 = phi_598_;
            workgroupBarrier();
            let _e329 = params.member.member_2.member_1;
            if (_e329 == 1u) {
                phi_607_ = (_e175 == _e178);
            } else {
                phi_607_ = false;
            }
            let _e333 = phi_607_;
            let _e334 = (_e40 / 32u);
            let _e335 = (_e40 % 32u);
            let _e336 = (_e334 * 32u);
            let _e338 = atomicLoad((&counters[_e334]));
            let _e339 = (_e338 / 4u);
            if ((_e338 % 4u) > 0u) {
                phi_630_ = (_e339 + 1u);
            } else {
                phi_630_ = _e339;
            }
            let _e344 = phi_630_;
            phi_633_ = type_9(0u, _e344);
            phi_636_ = 0u;
            loop {
                let _e347 = phi_633_;
                let _e349 = phi_636_;
                local = _e349;
                local_1 = _e349;
                if (_e347.member < _e347.member_1) {
                    phi_634_ = type_9((_e347.member + 1u), _e347.member_1);
                    phi_659_ = type_9(1u, _e347.member);
                } else {
                    phi_634_ = _e347;
                    phi_659_ = type_9(0u, type_9().member_1);
                }
                let _e361 = phi_634_;
                let _e363 = phi_659_;
                let _e367 = (bitcast<i32>(_e363.member) != 0i);
                if _e367 {
                    let _e368 = (4u * _e363.member_1);
                    let _e371 = columns[(_e336 + _e368)];
                    let _e410 = columns[((_e336 + _e368) + 1u)];
                    let _e451 = columns[((_e336 + _e368) + 2u)];
                    let _e492 = columns[((_e336 + _e368) + 3u)];
                    phi_637_ = (_e349 | ((((select(0u, 1u, ((((((_e326.member[0] <= _e371.member_1[0]) && (_e371.member[0] <= _e326.member_1[0])) && (_e326.member[1] <= _e371.member_1[1])) && (_e371.member[1] <= _e326.member_1[1])) && (_e326.member[2] <= _e371.member_1[2])) && (_e371.member[2] <= _e326.member_1[2]))) << bitcast<u32>((_e368 & 31u))) | (select(0u, 1u, ((((((_e326.member[0] <= _e410.member_1[0]) && (_e410.member[0] <= _e326.member_1[0])) && (_e326.member[1] <= _e410.member_1[1])) && (_e410.member[1] <= _e326.member_1[1])) && (_e326.member[2] <= _e410.member_1[2])) && (_e410.member[2] <= _e326.member_1[2]))) << bitcast<u32>(((_e368 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e326.member[0] <= _e451.member_1[0]) && (_e451.member[0] <= _e326.member_1[0])) && (_e326.member[1] <= _e451.member_1[1])) && (_e451.member[1] <= _e326.member_1[1])) && (_e326.member[2] <= _e451.member_1[2])) && (_e451.member[2] <= _e326.member_1[2]))) << bitcast<u32>(((_e368 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e326.member[0] <= _e492.member_1[0]) && (_e492.member[0] <= _e326.member_1[0])) && (_e326.member[1] <= _e492.member_1[1])) && (_e492.member[1] <= _e326.member_1[1])) && (_e326.member[2] <= _e492.member_1[2])) && (_e492.member[2] <= _e326.member_1[2]))) << bitcast<u32>(((_e368 + 3u) & 31u)))));
                } else {
                    phi_637_ = u32();
                }
                let _e532 = phi_637_;
                continue;
                continuing {
                    phi_633_ = _e361;
                    phi_636_ = _e532;
                    break if !(_e367);
                }
            }
            if (_e338 < 32u) {
                let _e540 = local;
                phi_848_ = (_e540 & ((1u << bitcast<u32>((_e338 & 31u))) - 1u));
            } else {
                let _e811 = local_1;
                phi_848_ = _e811;
            }
            let _e543 = phi_848_;
            if _e333 {
                phi_854_ = type_9(0u, _e338);
                phi_857_ = _e543;
                loop {
                    let _e546 = phi_854_;
                    let _e548 = phi_857_;
                    local_2 = _e548;
                    if (_e546.member < _e546.member_1) {
                        phi_855_ = type_9((_e546.member + 1u), _e546.member_1);
                        phi_880_ = type_9(1u, _e546.member);
                    } else {
                        phi_855_ = _e546;
                        phi_880_ = type_9(0u, type_9().member_1);
                    }
                    let _e560 = phi_855_;
                    let _e562 = phi_880_;
                    let _e566 = (bitcast<i32>(_e562.member) != 0i);
                    if _e566 {
                        let _e569 = names[(_e336 + _e562.member_1)];
                        if _e333 {
                            let _e570 = (_e335 < _e569);
                            if _e570 {
                                phi_904_ = bool();
                            } else {
                                if (_e335 == _e569) {
                                    phi_903_ = true;
                                } else {
                                    phi_903_ = false;
                                }
                                let _e573 = phi_903_;
                                phi_904_ = _e573;
                            }
                            let _e575 = phi_904_;
                            phi_905_ = _e575;
                            phi_906_ = _e570;
                        } else {
                            phi_905_ = bool();
                            phi_906_ = true;
                        }
                        let _e577 = phi_905_;
                        let _e579 = phi_906_;
                        if _e579 {
                            phi_910_ = true;
                        } else {
                            phi_910_ = _e577;
                        }
                        let _e581 = phi_910_;
                        if _e581 {
                            phi_918_ = false;
                        } else {
                            phi_918_ = true;
                        }
                        let _e583 = phi_918_;
                        if _e583 {
                            phi_926_ = (_e548 & ~((1u << bitcast<u32>((_e562.member_1 & 31u)))));
                        } else {
                            phi_926_ = _e548;
                        }
                        let _e590 = phi_926_;
                        phi_858_ = _e590;
                    } else {
                        phi_858_ = u32();
                    }
                    let _e592 = phi_858_;
                    continue;
                    continuing {
                        phi_854_ = _e560;
                        phi_857_ = _e592;
                        break if !(_e566);
                    }
                }
                let _e826 = local_2;
                phi_927_ = _e826;
            } else {
                phi_927_ = _e543;
            }
            let _e595 = phi_927_;
            let _e597 = countOneBits(_e595);
            if (_e597 > 0u) {
                let _e600 = atomicAdd((&counters[4u]), _e597);
                phi_937_ = type_9(_e595, _e600);
            } else {
                phi_937_ = type_9(_e595, 0u);
            }
            let _e603 = phi_937_;
            workgroupBarrier();
            if (_e40 == 0u) {
                let _e606 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e606;
            }
            let _e609 = workgroupUniformLoad((&n_hits[0u]));
            let _e610 = (_e609 / 512u);
            if ((_e609 % 512u) > 0u) {
                phi_963_ = (_e610 + 1u);
            } else {
                phi_963_ = _e610;
            }
            let _e615 = phi_963_;
            phi_966_ = type_9(0u, _e615);
            phi_969_ = _e603;
            loop {
                let _e618 = phi_966_;
                let _e620 = phi_969_;
                if (_e618.member < _e618.member_1) {
                    phi_967_ = type_9((_e618.member + 1u), _e618.member_1);
                    phi_992_ = type_9(1u, _e618.member);
                } else {
                    phi_967_ = _e618;
                    phi_992_ = type_9(0u, type_9().member_1);
                }
                let _e632 = phi_967_;
                let _e634 = phi_992_;
                let _e638 = (bitcast<i32>(_e634.member) != 0i);
                if _e638 {
                    let _e639 = (_e40 / 32u);
                    let _e641 = (_e634.member_1 * 512u);
                    phi_1009_ = _e620;
                    phi_1012_ = type_9(0u, countOneBits(_e620.member));
                    loop {
                        let _e646 = phi_1009_;
                        let _e648 = phi_1012_;
                        local_3 = _e646;
                        if (_e648.member < _e648.member_1) {
                            phi_1013_ = type_9((_e648.member + 1u), _e648.member_1);
                            phi_1035_ = type_9(1u, _e648.member);
                        } else {
                            phi_1013_ = _e648;
                            phi_1035_ = type_9(0u, type_9().member_1);
                        }
                        let _e660 = phi_1013_;
                        let _e662 = phi_1035_;
                        if (bitcast<i32>(_e662.member) != 0i) {
                            let _e667 = (_e646.member_1 - _e641);
                            if (_e667 >= 512u) {
                                phi_1069_ = type_9();
                                phi_1070_ = false;
                            } else {
                                let _e676 = names[((_e639 * 32u) + select(firstTrailingBit(_e646.member), 32u, (_e646.member == 0u)))];
                                hits[_e667] = (((_e639 << bitcast<u32>(10i)) | ((_e40 % 32u) << bitcast<u32>(5i))) | _e676);
                                phi_1069_ = type_9((_e646.member & (_e646.member - 1u)), (_e646.member_1 + 1u));
                                phi_1070_ = true;
                            }
                            let _e692 = phi_1069_;
                            let _e694 = phi_1070_;
                            phi_1010_ = _e692;
                            phi_1071_ = _e694;
                        } else {
                            phi_1010_ = type_9();
                            phi_1071_ = false;
                        }
                        let _e696 = phi_1010_;
                        let _e698 = phi_1071_;
                        continue;
                        continuing {
                            phi_1009_ = _e696;
                            phi_1012_ = _e660;
                            break if !(_e698);
                        }
                    }
                    workgroupBarrier();
                    let _e701 = n_hits[0u];
                    let _e702 = (_e701 - _e641);
                    if (512u < _e702) {
                        phi_1079_ = 512u;
                    } else {
                        phi_1079_ = _e702;
                    }
                    let _e705 = phi_1079_;
                    if (_e40 == 0u) {
                        atomicStore((&counters[7u]), _e705);
                    }
                    workgroupBarrier();
                    if (_e40 == 0u) {
                        let _e710 = atomicLoad((&counters[7u]));
                        if (_e710 > 0u) {
                            let _e713 = atomicAdd((&output.member[0u]), _e710);
                            if ((_e713 + _e710) < _e713) {
                                let _e717 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e713);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e723 = atomicLoad((&counters[8u]));
                    phi_1116_ = type_9(0u, 4u);
                    loop {
                        let _e725 = phi_1116_;
                        if (_e725.member < _e725.member_1) {
                            phi_1117_ = type_9((_e725.member + 1u), _e725.member_1);
                            phi_1140_ = type_9(1u, _e725.member);
                        } else {
                            phi_1117_ = _e725;
                            phi_1140_ = type_9(0u, type_9().member_1);
                        }
                        let _e737 = phi_1117_;
                        let _e739 = phi_1140_;
                        if (bitcast<i32>(_e739.member) != 0i) {
                            let _e745 = (_e40 + (_e739.member_1 * 128u));
                            if (_e745 >= _e705) {
                                phi_1185_ = false;
                            } else {
                                let _e748 = hits[_e745];
                                let _e751 = ((_e748 >> bitcast<u32>(10i)) & 3u);
                                let _e758 = firsts[(2u * _e751)];
                                let _e763 = firsts[((2u * _e751) + 1u)];
                                let _e767 = params.member.member_1.member_3;
                                let _e768 = (_e723 + _e745);
                                if (_e768 < _e767) {
                                    let _e770 = (2u * _e768);
                                    atomicStore((&output.member[(4u + _e770)]), (_e758 + ((_e748 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e770 + 5u)]), (_e763 + (_e748 & 31u)));
                                }
                                phi_1185_ = true;
                            }
                            let _e776 = phi_1185_;
                            phi_1186_ = _e776;
                        } else {
                            phi_1186_ = false;
                        }
                        let _e778 = phi_1186_;
                        continue;
                        continuing {
                            phi_1116_ = _e737;
                            break if !(_e778);
                        }
                    }
                    workgroupBarrier();
                    let _e849 = local_3;
                    phi_970_ = _e849;
                } else {
                    phi_970_ = type_9();
                }
                let _e781 = phi_970_;
                continue;
                continuing {
                    phi_966_ = _e632;
                    phi_969_ = _e781;
                    break if !(_e638);
                }
            }
        }
        continue;
        continuing {
            phi_245_ = _e122;
            break if !(_e128);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
