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
    var phi_193_: u32;
    var phi_241_: u32;
    var phi_244_: type_9;
    var phi_316_: u32;
    var phi_559_: bool;
    var phi_597_: type_24;
    var phi_632_: type_9;
    var phi_635_: u32;
    var phi_636_: u32;
    var local: u32;
    var local_1: u32;
    var phi_877_: type_9;
    var phi_880_: u32;
    var phi_881_: u32;
    var phi_945_: u32;
    var phi_946_: u32;
    var phi_953_: type_9;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_1026_: u32;
    var phi_1058_: type_9;
    var phi_1120_: type_9;
    var phi_1123_: u32;
    var phi_1124_: u32;
    var phi_1297_: u32;
    var phi_1304_: type_9;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var local_2: u32;
    var local_3: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e37 = id_2;
    let _e38 = n_2;
    let _e39 = lane_2;
    let _e48 = ((_e37.y * _e38.x) + _e37.x);
    let _e51 = (_e38.x * _e38.y);
    let _e54 = params.member.member_1.member_2;
    let _e56 = input.member[0u];
    let _e58 = select(_e56, _e54, (_e54 < _e56));
    let _e59 = (_e39 / 32u);
    let _e63 = params.member.member_1.member_1;
    if (_e58 > _e63) {
        let _e67 = params.member.member_1.member_1;
        let _e68 = (_e58 - _e67);
        let _e71 = params.member.member_2.member_3;
        if (_e71 == 0u) {
            return;
        }
        let _e73 = (_e68 / _e71);
        if (_e71 == 0u) {
            return;
        }
        phi_193_ = select(_e73, (_e73 + 1u), ((_e68 % _e71) > 0u));
    } else {
        phi_193_ = 0u;
    }
    let _e80 = phi_193_;
    let _e83 = params.member.member_2.member_4;
    let _e85 = select(_e80, _e83, (_e83 < _e80));
    let _e86 = (_e85 / 4u);
    let _e90 = select(_e86, (_e86 + 1u), ((_e85 % 4u) > 0u));
    if (_e90 > _e48) {
        let _e92 = (_e90 - _e48);
        if (_e51 == 0u) {
            return;
        }
        let _e94 = (_e92 / _e51);
        if (_e51 == 0u) {
            return;
        }
        phi_241_ = select(_e94, (_e94 + 1u), ((_e92 % _e51) > 0u));
    } else {
        phi_241_ = 0u;
    }
    let _e101 = phi_241_;
    phi_244_ = type_9(0u, _e101);
    loop {
        let _e104 = phi_244_;
        let _e107 = (_e104.member < _e104.member_1);
        let _e120 = (bitcast<i32>(select(0u, 1u, _e107)) != 0i);
        if _e120 {
            let _e125 = (((_e48 + (select(type_9().member_1, _e104.member, _e107) * _e51)) * 4u) + (_e39 / 32u));
            let _e128 = params.member.member_1.member_1;
            if (_e58 > _e128) {
                let _e132 = params.member.member_1.member_1;
                let _e133 = (_e58 - _e132);
                let _e136 = params.member.member_2.member_3;
                if (_e136 == 0u) {
                    return;
                }
                let _e138 = (_e133 / _e136);
                if (_e136 == 0u) {
                    return;
                }
                phi_316_ = select(_e138, (_e138 + 1u), ((_e133 % _e136) > 0u));
            } else {
                phi_316_ = 0u;
            }
            let _e145 = phi_316_;
            let _e148 = params.member.member_2.member_4;
            let _e151 = (_e125 < select(_e145, _e148, (_e148 < _e145)));
            let _e154 = params.member.member_1.member_1;
            let _e157 = params.member.member_2.member_3;
            let _e161 = (2u * (_e154 + select(0u, (_e125 * _e157), _e151)));
            let _e164 = input.member[(4u + _e161)];
            let _e167 = input.member[(_e161 + 5u)];
            if (_e39 <= 5u) {
                atomicStore((&counters[_e39]), 0u);
            }
            workgroupBarrier();
            if ((_e39 % 32u) == 0u) {
                firsts[(2u * _e59)] = (_e164 * 32u);
                firsts[((2u * _e59) + 1u)] = (_e167 * 32u);
            }
            let _e180 = params.member.member_2.member_1;
            let _e181 = (_e180 == 0u);
            let _e182 = select(1u, 0u, _e181);
            let _e183 = select(1u, 2u, _e181);
            let _e184 = (_e39 / 32u);
            let _e185 = (_e39 % 32u);
            let _e187 = params.member.member_2.member_2;
            let _e191 = params.member.member_2.member[_e187][_e182];
            let _e194 = nodes.member[(_e191 + _e164)];
            let _e208 = params.member.member_2.member_2;
            let _e212 = params.member.member_2.member[_e208][_e183];
            let _e215 = nodes.member[(_e212 + _e167)];
            let _e229 = params.member.member_2.member_2;
            let _e236 = params.member.member_2.member[(_e229 - 1u)][_e182];
            let _e239 = nodes.member[(_e236 + ((_e164 * 32u) + _e185))];
            let _e256 = params.member.member_2.member_2;
            let _e263 = params.member.member_2.member[(_e256 - 1u)][_e183];
            let _e266 = nodes.member[(_e263 + ((_e167 * 32u) + _e185))];
            if _e151 {
                phi_559_ = ((((((_e239.member.x <= _e215.member_1.y) && (_e215.member.x <= _e239.member_1.y)) && (_e239.member.y <= _e215.member_2.x)) && (_e215.member.y <= _e239.member_2.x)) && (_e239.member_1.x <= _e215.member_2.y)) && (_e215.member_1.x <= _e239.member_2.y));
            } else {
                phi_559_ = false;
            }
            let _e291 = phi_559_;
            if _e151 {
                if ((((((_e266.member.x <= _e194.member_1.y) && (_e194.member.x <= _e266.member_1.y)) && (_e266.member.y <= _e194.member_2.x)) && (_e194.member.y <= _e266.member_2.x)) && (_e266.member_1.x <= _e194.member_2.y)) && (_e194.member_1.x <= _e266.member_2.y)) {
                    let _e305 = atomicAdd((&counters[_e184]), 1u);
                    let _e306 = ((_e184 * 32u) + _e305);
                    columns[_e306] = type_24(array<f32, 3>(_e266.member.x, _e266.member.y, _e266.member_1.x), array<f32, 3>(_e266.member_1.y, _e266.member_2.x, _e266.member_2.y));
                    names[_e306] = _e185;
                }
            }
            if _e291 {
                phi_597_ = type_24(array<f32, 3>(_e239.member.x, _e239.member.y, _e239.member_1.x), array<f32, 3>(_e239.member_1.y, _e239.member_2.x, _e239.member_2.y));
            } else {
                phi_597_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e313 = phi_597_;
            workgroupBarrier();
            let _e316 = params.member.member_2.member_1;
            let _e319 = select(false, (_e164 == _e167), (_e316 == 1u));
            let _e320 = (_e39 / 32u);
            let _e321 = (_e39 % 32u);
            let _e322 = (_e320 * 32u);
            let _e324 = atomicLoad((&counters[_e320]));
            let _e325 = (_e324 / 4u);
            phi_632_ = type_9(0u, select(_e325, (_e325 + 1u), ((_e324 % 4u) > 0u)));
            phi_635_ = 0u;
            loop {
                let _e332 = phi_632_;
                let _e334 = phi_635_;
                local = _e334;
                local_1 = _e334;
                let _e337 = (_e332.member < _e332.member_1);
                let _e350 = (bitcast<i32>(select(0u, 1u, _e337)) != 0i);
                if _e350 {
                    let _e351 = (4u * select(type_9().member_1, _e332.member, _e337));
                    let _e354 = columns[(_e322 + _e351)];
                    let _e393 = columns[((_e322 + _e351) + 1u)];
                    let _e434 = columns[((_e322 + _e351) + 2u)];
                    let _e475 = columns[((_e322 + _e351) + 3u)];
                    phi_636_ = (_e334 | ((((select(0u, 1u, ((((((_e313.member[0] <= _e354.member_1[0]) && (_e354.member[0] <= _e313.member_1[0])) && (_e313.member[1] <= _e354.member_1[1])) && (_e354.member[1] <= _e313.member_1[1])) && (_e313.member[2] <= _e354.member_1[2])) && (_e354.member[2] <= _e313.member_1[2]))) << bitcast<u32>((_e351 & 31u))) | (select(0u, 1u, ((((((_e313.member[0] <= _e393.member_1[0]) && (_e393.member[0] <= _e313.member_1[0])) && (_e313.member[1] <= _e393.member_1[1])) && (_e393.member[1] <= _e313.member_1[1])) && (_e313.member[2] <= _e393.member_1[2])) && (_e393.member[2] <= _e313.member_1[2]))) << bitcast<u32>(((_e351 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e313.member[0] <= _e434.member_1[0]) && (_e434.member[0] <= _e313.member_1[0])) && (_e313.member[1] <= _e434.member_1[1])) && (_e434.member[1] <= _e313.member_1[1])) && (_e313.member[2] <= _e434.member_1[2])) && (_e434.member[2] <= _e313.member_1[2]))) << bitcast<u32>(((_e351 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e313.member[0] <= _e475.member_1[0]) && (_e475.member[0] <= _e313.member_1[0])) && (_e313.member[1] <= _e475.member_1[1])) && (_e475.member[1] <= _e313.member_1[1])) && (_e313.member[2] <= _e475.member_1[2])) && (_e475.member[2] <= _e313.member_1[2]))) << bitcast<u32>(((_e351 + 3u) & 31u)))));
                } else {
                    phi_636_ = u32();
                }
                let _e515 = phi_636_;
                continue;
                continuing {
                    phi_632_ = type_9(select(_e332.member, (_e332.member + 1u), _e337), select(_e332.member_1, _e332.member_1, _e337));
                    phi_635_ = _e515;
                    break if !(_e350);
                }
            }
            let _e523 = local;
            let _e526 = local_1;
            let _e527 = select(_e526, (_e523 & ((1u << bitcast<u32>((_e324 & 31u))) - 1u)), (_e324 < 32u));
            let _e530 = params.member.member.member_1;
            if ((_e530 & 256u) != 0u) {
                if select(!((_e313.member[0] <= _e313.member_1[0])), true, ((bitcast<u32>(_e313.member_1[0]) & 1u) == 1u)) {
                    phi_877_ = type_9(0u, _e324);
                    phi_880_ = _e527;
                    loop {
                        let _e547 = phi_877_;
                        let _e549 = phi_880_;
                        local_2 = _e549;
                        let _e552 = (_e547.member < _e547.member_1);
                        let _e563 = select(type_9().member_1, _e547.member, _e552);
                        let _e565 = (bitcast<i32>(select(0u, 1u, _e552)) != 0i);
                        if _e565 {
                            let _e568 = columns[(_e322 + _e563)];
                            phi_881_ = select(_e549, (_e549 & ~((1u << bitcast<u32>((_e563 & 31u))))), select(!((_e568.member[0] <= _e568.member_1[0])), true, ((bitcast<u32>(_e568.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_881_ = u32();
                        }
                        let _e586 = phi_881_;
                        continue;
                        continuing {
                            phi_877_ = type_9(select(_e547.member, (_e547.member + 1u), _e552), select(_e547.member_1, _e547.member_1, _e552));
                            phi_880_ = _e586;
                            break if !(_e565);
                        }
                    }
                    let _e870 = local_2;
                    phi_945_ = _e870;
                } else {
                    phi_945_ = _e527;
                }
                let _e589 = phi_945_;
                phi_946_ = _e589;
            } else {
                phi_946_ = _e527;
            }
            let _e591 = phi_946_;
            if _e319 {
                phi_953_ = type_9(0u, _e324);
                phi_956_ = _e591;
                loop {
                    let _e594 = phi_953_;
                    let _e596 = phi_956_;
                    local_3 = _e596;
                    let _e599 = (_e594.member < _e594.member_1);
                    let _e610 = select(type_9().member_1, _e594.member, _e599);
                    let _e612 = (bitcast<i32>(select(0u, 1u, _e599)) != 0i);
                    if _e612 {
                        let _e615 = names[(_e322 + _e610)];
                        let _e616 = (_e321 < _e615);
                        phi_957_ = select(_e596, (_e596 & ~((1u << bitcast<u32>((_e610 & 31u))))), select(true, false, select(select(bool(), select(select(false, true, (_e321 == _e615)), bool(), _e616), _e319), true, select(true, _e616, _e319))));
                    } else {
                        phi_957_ = u32();
                    }
                    let _e631 = phi_957_;
                    continue;
                    continuing {
                        phi_953_ = type_9(select(_e594.member, (_e594.member + 1u), _e599), select(_e594.member_1, _e594.member_1, _e599));
                        phi_956_ = _e631;
                        break if !(_e612);
                    }
                }
                let _e877 = local_3;
                phi_1026_ = _e877;
            } else {
                phi_1026_ = _e591;
            }
            let _e634 = phi_1026_;
            let _e637 = atomicAdd((&counters[4u]), countOneBits(_e634));
            workgroupBarrier();
            if (_e39 == 0u) {
                let _e640 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e640;
            }
            let _e643 = workgroupUniformLoad((&n_hits[0u]));
            let _e644 = (_e643 / 512u);
            phi_1058_ = type_9(0u, select(_e644, (_e644 + 1u), ((_e643 % 512u) > 0u)));
            loop {
                let _e651 = phi_1058_;
                let _e654 = (_e651.member < _e651.member_1);
                let _e667 = (bitcast<i32>(select(0u, 1u, _e654)) != 0i);
                if _e667 {
                    let _e668 = (_e39 / 32u);
                    let _e674 = ((_e668 << bitcast<u32>(10i)) | ((_e39 % 32u) << bitcast<u32>(5i)));
                    let _e675 = (select(type_9().member_1, _e651.member, _e654) * 512u);
                    let _e678 = atomicLoad((&counters[_e668]));
                    let _e679 = (_e678 / 4u);
                    phi_1120_ = type_9(0u, select(_e679, (_e679 + 1u), ((_e678 % 4u) > 0u)));
                    phi_1123_ = (_e637 - _e675);
                    loop {
                        let _e686 = phi_1120_;
                        let _e688 = phi_1123_;
                        let _e691 = (_e686.member < _e686.member_1);
                        let _e704 = (bitcast<i32>(select(0u, 1u, _e691)) != 0i);
                        if _e704 {
                            let _e705 = (4u * select(type_9().member_1, _e686.member, _e691));
                            let _e711 = (((_e634 >> bitcast<u32>((_e705 & 31u))) & 1u) == 1u);
                            if _e711 {
                                if (_e688 < 512u) {
                                    hits[_e688] = (_e674 + _e705);
                                }
                            }
                            let _e715 = select(_e688, (_e688 + 1u), _e711);
                            let _e723 = (((_e634 >> bitcast<u32>(((_e705 + 1u) & 31u))) & 1u) == 1u);
                            if _e723 {
                                if (_e715 < 512u) {
                                    hits[_e715] = ((_e674 + _e705) + 1u);
                                }
                            }
                            let _e727 = select(_e715, (_e715 + 1u), _e723);
                            let _e735 = (((_e634 >> bitcast<u32>(((_e705 + 2u) & 31u))) & 1u) == 1u);
                            if _e735 {
                                if (_e727 < 512u) {
                                    hits[_e727] = ((_e674 + _e705) + 2u);
                                }
                            }
                            let _e739 = select(_e727, (_e727 + 1u), _e735);
                            let _e747 = (((_e634 >> bitcast<u32>(((_e705 + 3u) & 31u))) & 1u) == 1u);
                            if _e747 {
                                if (_e739 < 512u) {
                                    hits[_e739] = ((_e674 + _e705) + 3u);
                                }
                            }
                            phi_1124_ = select(_e739, (_e739 + 1u), _e747);
                        } else {
                            phi_1124_ = u32();
                        }
                        let _e753 = phi_1124_;
                        continue;
                        continuing {
                            phi_1120_ = type_9(select(_e686.member, (_e686.member + 1u), _e691), select(_e686.member_1, _e686.member_1, _e691));
                            phi_1123_ = _e753;
                            break if !(_e704);
                        }
                    }
                    workgroupBarrier();
                    let _e756 = n_hits[0u];
                    let _e757 = (_e756 - _e675);
                    let _e759 = select(_e757, 512u, (512u < _e757));
                    if (_e39 == 0u) {
                        atomicStore((&counters[5u]), _e759);
                    }
                    workgroupBarrier();
                    if (_e39 == 0u) {
                        let _e764 = atomicLoad((&counters[5u]));
                        if (_e764 > 0u) {
                            let _e768 = params.member.member.member_1;
                            if ((_e768 & 1024u) != 0u) {
                                let _e778 = atomicAdd((&output.member[0u]), _e764);
                                let _e779 = (_e778 + _e764);
                                let _e781 = select(_e779, 4294967295u, (_e779 < _e778));
                                let _e784 = params.member.member_1.member_3;
                                if (_e781 > _e784) {
                                    let _e787 = atomicMax((&output.member[2u]), _e781);
                                }
                                phi_1297_ = _e778;
                            } else {
                                let _e772 = atomicAdd((&output.member[0u]), _e764);
                                if ((_e772 + _e764) < _e772) {
                                    let _e776 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1297_ = _e772;
                            }
                            let _e789 = phi_1297_;
                            atomicStore((&counters[6u]), _e789);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e793 = atomicLoad((&counters[6u]));
                    phi_1304_ = type_9(0u, 4u);
                    loop {
                        let _e795 = phi_1304_;
                        let _e798 = (_e795.member < _e795.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e798)) != 0i) {
                            let _e813 = (_e39 + (select(type_9().member_1, _e795.member, _e798) * 128u));
                            if (_e813 >= _e759) {
                                phi_1377_ = false;
                            } else {
                                let _e816 = hits[_e813];
                                let _e819 = ((_e816 >> bitcast<u32>(10i)) & 3u);
                                let _e827 = names[((_e819 * 32u) + (_e816 & 31u))];
                                let _e830 = firsts[(2u * _e819)];
                                let _e835 = firsts[((2u * _e819) + 1u)];
                                let _e839 = params.member.member_1.member_3;
                                let _e840 = (_e793 + _e813);
                                if (_e840 < _e839) {
                                    let _e842 = (2u * _e840);
                                    atomicStore((&output.member[(4u + _e842)]), (_e830 + ((_e816 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e842 + 5u)]), (_e835 + _e827));
                                }
                                phi_1377_ = true;
                            }
                            let _e848 = phi_1377_;
                            phi_1378_ = _e848;
                        } else {
                            phi_1378_ = false;
                        }
                        let _e850 = phi_1378_;
                        continue;
                        continuing {
                            phi_1304_ = type_9(select(_e795.member, (_e795.member + 1u), _e798), select(_e795.member_1, _e795.member_1, _e798));
                            break if !(_e850);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1058_ = type_9(select(_e651.member, (_e651.member + 1u), _e654), select(_e651.member_1, _e651.member_1, _e654));
                    break if !(_e667);
                }
            }
        }
        continue;
        continuing {
            phi_244_ = type_9(select(_e104.member, (_e104.member + 1u), _e107), select(_e104.member_1, _e104.member_1, _e107));
            break if !(_e120);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
