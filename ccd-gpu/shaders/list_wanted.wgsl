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
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_23 {
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_35 {
    member: array<vec4<f32>>,
}

struct type_40 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> rows: array<u32, 4>;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 384>;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(3) 
var<storage> ends: type_35;
@group(0) @binding(4) 
var<storage> bodies: type_11;
@group(0) @binding(5) 
var<storage> keys: type_11;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_40;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_1[0] > param[0]), (param_1[1] == param[1])), true, (param_1[1] > param[1]));
    return array<u32, 2>(select(param[0], param_1[0], _e14), select(param[1], param_1[1], _e14));
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_2[0] > param_3[0]), (param_2[1] == param_3[1])), true, (param_2[1] > param_3[1]));
    return array<u32, 2>(select(param_2[0], param_3[0], _e14), select(param_2[1], param_3[1], _e14));
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_210_: u32;
    var phi_237_: u32;
    var phi_345_: u32;
    var phi_520_: bool;
    var phi_556_: type_9;
    var phi_559_: u32;
    var phi_560_: u32;
    var local: u32;
    var local_1: u32;
    var phi_893_: type_9;
    var phi_943_: type_9;
    var phi_946_: u32;
    var phi_948_: u32;
    var phi_950_: u32;
    var phi_947_: u32;
    var phi_949_: u32;
    var phi_951_: u32;
    var phi_1059_: type_9;
    var phi_1062_: u32;
    var phi_1270_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1346_: bool;
    var phi_1432_: array<type_29, 2>;
    var phi_1476_: bool;
    var phi_1477_: bool;
    var phi_1641_: bool;
    var phi_1682_: type_16;
    var phi_1685_: u32;
    var phi_1683_: type_16;
    var phi_1726_: type_17;
    var phi_1805_: u32;
    var phi_1686_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1853_: bool;
    var phi_1854_: bool;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1861_: bool;
    var phi_1865_: bool;
    var phi_1870_: bool;
    var phi_1875_: bool;
    var phi_1880_: bool;
    var phi_1925_: type_9;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2374_: bool;
    var phi_2375_: bool;
    var phi_2376_: bool;
    var local_4: bool;
    var local_5: bool;
    var local_6: bool;
    var phi_2393_: bool;
    var phi_2394_: bool;
    var phi_2395_: bool;
    var phi_2400_: bool;
    var phi_2401_: bool;
    var phi_2402_: bool;
    var phi_2403_: bool;
    var phi_2424_: u32;
    var phi_2425_: u32;
    var phi_2426_: bool;
    var phi_1063_: u32;
    var phi_2427_: bool;
    var local_7: u32;
    var phi_2486_: u32;
    var phi_2510_: type_9;
    var phi_2513_: u32;
    var local_8: u32;
    var phi_2602_: type_9;
    var phi_2617_: u32;
    var phi_2514_: u32;
    var phi_346_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e76 = params.member.member_1.member_2;
    let _e78 = input.member[0u];
    let _e80 = select(_e78, _e76, (_e76 < _e78));
    let _e83 = params.member.member_1.member_1;
    if (_e80 > _e83) {
        let _e87 = params.member.member_1.member_1;
        phi_210_ = (_e80 - _e87);
    } else {
        phi_210_ = 0u;
    }
    let _e90 = phi_210_;
    let _e93 = params.member.member_2.member_3;
    if (_e93 == 1u) {
        phi_237_ = _e90;
    } else {
        let _e97 = params.member.member_2.member_3;
        if (_e97 == 0u) {
            return;
        }
        let _e99 = (_e90 / _e97);
        if (_e97 == 0u) {
            return;
        }
        phi_237_ = select(_e99, (_e99 + 1u), ((_e90 % _e97) > 0u));
    }
    let _e106 = phi_237_;
    let _e109 = params.member.member_2.member_4;
    let _e111 = select(_e106, _e109, (_e109 < _e106));
    let _e114 = params.member.member_2.member_1;
    let _e115 = (_e114 == 0u);
    let _e116 = select(1u, 0u, _e115);
    let _e121 = params.member.member_2.member[1u][_e116];
    let _e125 = params.member.member_2.member[0u][_e116];
    let _e129 = params.member.member_2.member[0u][select(1u, 2u, _e115)];
    let _e131 = params.member.member;
    let _e134 = params.member.member_2.member_1;
    let _e144 = (((_e131.member_5 + (2f * _e131.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
    if (_e57 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    phi_345_ = ((_e55.y * _e56.x) + _e55.x);
    loop {
        let _e148 = phi_345_;
        let _e149 = (_e111 / 4u);
        let _e154 = (_e148 < select(_e149, (_e149 + 1u), ((_e111 % 4u) > 0u)));
        if _e154 {
            let _e157 = ((_e148 * 4u) + (_e57 / 32u));
            let _e158 = (_e157 < _e111);
            let _e161 = params.member.member_1.member_1;
            let _e164 = params.member.member_2.member_3;
            let _e168 = (2u * (_e161 + select(0u, (_e157 * _e164), _e158)));
            let _e171 = input.member[(4u + _e168)];
            let _e174 = input.member[(_e168 + 5u)];
            if (_e57 <= 5u) {
                atomicStore((&counters[_e57]), 0u);
            }
            workgroupBarrier();
            let _e179 = select(false, (_e171 == _e174), (_e134 == 1u));
            let _e180 = (_e57 / 32u);
            let _e181 = (_e57 % 32u);
            let _e184 = ((_e125 + (_e171 * 32u)) + _e181);
            let _e187 = ((_e129 + (_e174 * 32u)) + _e181);
            let _e190 = nodes.member[(_e121 + _e171)];
            let _e204 = nodes.member[_e184];
            let _e218 = nodes.member[_e187];
            if (_e181 == 0u) {
                rows[_e180] = _e184;
            }
            if _e158 {
                if _e179 {
                    phi_520_ = true;
                } else {
                    phi_520_ = ((((((_e218.member.x <= _e190.member_1.y) && (_e190.member.x <= _e218.member_1.y)) && (_e218.member.y <= _e190.member_2.x)) && (_e190.member.y <= _e218.member_2.x)) && (_e218.member_1.x <= _e190.member_2.y)) && (_e190.member_1.x <= _e218.member_2.y));
                }
                let _e245 = phi_520_;
                if _e245 {
                    let _e247 = atomicAdd((&counters[_e180]), 1u);
                    let _e250 = ((_e180 * 32u) + select(_e247, _e181, _e179));
                    columns[_e250] = type_29(array<f32, 3>(_e218.member.x, _e218.member.y, _e218.member_1.x), array<f32, 3>(_e218.member_1.y, _e218.member_2.x, _e218.member_2.y));
                    names[_e250] = _e187;
                }
            }
            workgroupBarrier();
            let _e256 = (_e57 / 32u);
            let _e258 = (_e256 * 32u);
            let _e260 = atomicLoad((&counters[_e256]));
            phi_556_ = type_9(0u, ((_e260 + 3u) / 4u));
            phi_559_ = 0u;
            loop {
                let _e265 = phi_556_;
                let _e267 = phi_559_;
                local = _e267;
                local_1 = _e267;
                let _e270 = (_e265.member < _e265.member_1);
                let _e283 = (bitcast<i32>(select(0u, 1u, _e270)) != 0i);
                if _e283 {
                    let _e284 = (4u * select(type_9().member_1, _e265.member, _e270));
                    let _e287 = columns[(_e258 + _e284)];
                    let _e311 = columns[((_e258 + _e284) + 1u)];
                    let _e338 = columns[((_e258 + _e284) + 2u)];
                    let _e365 = columns[((_e258 + _e284) + 3u)];
                    phi_560_ = (_e267 | ((((select(0u, 1u, ((((((_e204.member.x <= _e287.member_1[0]) && (_e287.member[0] <= _e204.member_1.y)) && (_e204.member.y <= _e287.member_1[1])) && (_e287.member[1] <= _e204.member_2.x)) && (_e204.member_1.x <= _e287.member_1[2])) && (_e287.member[2] <= _e204.member_2.y))) | (select(0u, 1u, ((((((_e204.member.x <= _e311.member_1[0]) && (_e311.member[0] <= _e204.member_1.y)) && (_e204.member.y <= _e311.member_1[1])) && (_e311.member[1] <= _e204.member_2.x)) && (_e204.member_1.x <= _e311.member_1[2])) && (_e311.member[2] <= _e204.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e204.member.x <= _e338.member_1[0]) && (_e338.member[0] <= _e204.member_1.y)) && (_e204.member.y <= _e338.member_1[1])) && (_e338.member[1] <= _e204.member_2.x)) && (_e204.member_1.x <= _e338.member_1[2])) && (_e338.member[2] <= _e204.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e204.member.x <= _e365.member_1[0]) && (_e365.member[0] <= _e204.member_1.y)) && (_e204.member.y <= _e365.member_1[1])) && (_e365.member[1] <= _e204.member_2.x)) && (_e204.member_1.x <= _e365.member_1[2])) && (_e365.member[2] <= _e204.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e284 & 31u))));
                } else {
                    phi_560_ = u32();
                }
                let _e394 = phi_560_;
                continue;
                continuing {
                    phi_556_ = type_9(select(_e265.member, (_e265.member + 1u), _e270), select(_e265.member_1, _e265.member_1, _e270));
                    phi_559_ = _e394;
                    break if !(_e283);
                }
            }
            let _e402 = local;
            let _e405 = local_1;
            let _e406 = select(_e405, (_e402 & ((1u << bitcast<u32>((_e260 & 31u))) - 1u)), (_e260 < 32u));
            let _e411 = select(_e406, (_e406 & (4294967294u << bitcast<u32>(((_e57 % 32u) & 31u)))), _e179);
            let _e415 = atomicAdd((&counters[4u]), countOneBits(_e411));
            workgroupBarrier();
            if (_e57 == 0u) {
                let _e418 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e418;
            }
            let _e421 = workgroupUniformLoad((&n_hits[0u]));
            let _e422 = (_e421 / 384u);
            if (_e57 == 0u) {
                let _e429 = atomicLoad((&counters[7u]));
                let _e431 = n_hits[0u];
                atomicStore((&counters[7u]), (_e429 + _e431));
            }
            phi_893_ = type_9(0u, select(_e422, (_e422 + 1u), ((_e421 % 384u) > 0u)));
            loop {
                let _e436 = phi_893_;
                let _e439 = (_e436.member < _e436.member_1);
                let _e452 = (bitcast<i32>(select(0u, 1u, _e439)) != 0i);
                if _e452 {
                    let _e453 = (_e57 / 32u);
                    let _e454 = (select(type_9().member_1, _e436.member, _e439) * 384u);
                    if (_e411 == 0u) {
                    } else {
                        let _e461 = atomicLoad((&counters[_e453]));
                        phi_943_ = type_9(0u, ((_e461 + 3u) / 4u));
                        phi_946_ = (_e415 - _e454);
                        phi_948_ = ((_e57 * 128u) + (_e453 * 32u));
                        phi_950_ = _e411;
                        loop {
                            let _e466 = phi_943_;
                            let _e468 = phi_946_;
                            let _e470 = phi_948_;
                            let _e472 = phi_950_;
                            let _e475 = (_e466.member < _e466.member_1);
                            let _e486 = (bitcast<i32>(select(0u, 1u, _e475)) != 0i);
                            if _e486 {
                                let _e487 = (_e472 & 1u);
                                if (_e487 == 0u) {
                                } else {
                                    if (_e468 < 384u) {
                                        hits[_e468] = _e470;
                                    }
                                }
                                let _e493 = select((_e468 + 1u), _e468, (_e487 == 0u));
                                let _e494 = (_e472 & 2u);
                                if (_e494 == 0u) {
                                } else {
                                    if (_e493 < 384u) {
                                        hits[_e493] = (_e470 + 1u);
                                    }
                                }
                                let _e501 = select((_e493 + 1u), _e493, (_e494 == 0u));
                                let _e502 = (_e472 & 4u);
                                if (_e502 == 0u) {
                                } else {
                                    if (_e501 < 384u) {
                                        hits[_e501] = (_e470 + 2u);
                                    }
                                }
                                let _e509 = select((_e501 + 1u), _e501, (_e502 == 0u));
                                let _e510 = (_e472 & 8u);
                                if (_e510 == 0u) {
                                } else {
                                    if (_e509 < 384u) {
                                        hits[_e509] = (_e470 + 3u);
                                    }
                                }
                                phi_947_ = select((_e509 + 1u), _e509, (_e510 == 0u));
                                phi_949_ = (_e470 + 4u);
                                phi_951_ = (_e472 >> bitcast<u32>(4i));
                            } else {
                                phi_947_ = u32();
                                phi_949_ = u32();
                                phi_951_ = u32();
                            }
                            let _e522 = phi_947_;
                            let _e524 = phi_949_;
                            let _e526 = phi_951_;
                            continue;
                            continuing {
                                phi_943_ = type_9(select(_e466.member, (_e466.member + 1u), _e475), select(_e466.member_1, _e466.member_1, _e475));
                                phi_946_ = _e522;
                                phi_948_ = _e524;
                                phi_950_ = _e526;
                                break if !(_e486);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e529 = n_hits[0u];
                    let _e530 = (_e529 - _e454);
                    let _e532 = select(_e530, 384u, (384u < _e530));
                    phi_1059_ = type_9(0u, 3u);
                    phi_1062_ = 0u;
                    loop {
                        let _e534 = phi_1059_;
                        let _e536 = phi_1062_;
                        local_7 = _e536;
                        local_8 = _e536;
                        let _e539 = (_e534.member < _e534.member_1);
                        let _e550 = select(type_9().member_1, _e534.member, _e539);
                        if (bitcast<i32>(select(0u, 1u, _e539)) != 0i) {
                            let _e554 = (_e57 + (_e550 * 128u));
                            if (_e554 >= _e532) {
                                phi_2425_ = u32();
                                phi_2426_ = false;
                            } else {
                                let _e557 = hits[_e554];
                                let _e560 = rows[(_e557 / 4096u)];
                                let _e563 = (_e560 + ((_e557 / 128u) % 32u));
                                let _e566 = names[(_e557 % 128u)];
                                if ((_e131.member_1 & 512u) != 0u) {
                                    let _e572 = ends.member[((3u * _e563) - (2u * (_e563 % 32u)))];
                                    let _e579 = ends.member[(((3u * _e563) - (2u * (_e563 % 32u))) + 32u)];
                                    let _e594 = ends.member[(((3u * _e563) - (2u * (_e563 % 32u))) + 64u)];
                                    let _e604 = ends.member[((3u * _e566) - (2u * (_e566 % 32u)))];
                                    let _e611 = ends.member[(((3u * _e566) - (2u * (_e566 % 32u))) + 32u)];
                                    let _e626 = ends.member[(((3u * _e566) - (2u * (_e566 % 32u))) + 64u)];
                                    phi_1270_ = !(((((((_e572.x - _e604.w) > _e144) && ((_e579.z - _e626.y) > _e144)) || (((_e604.x - _e572.w) > _e144) && ((_e611.z - _e594.y) > _e144))) || ((((_e572.y - _e611.x) > _e144) && ((_e579.w - _e626.z) > _e144)) || (((_e604.y - _e579.x) > _e144) && ((_e611.w - _e594.z) > _e144)))) || ((((_e572.z - _e611.y) > _e144) && ((_e594.x - _e626.w) > _e144)) || (((_e604.z - _e579.y) > _e144) && ((_e626.x - _e594.w) > _e144)))));
                                } else {
                                    phi_1270_ = true;
                                }
                                let _e668 = phi_1270_;
                                if _e668 {
                                    phi_1346_ = true;
                                } else {
                                    if ((_e131.member_1 & 2u) != 0u) {
                                        phi_1341_ = false;
                                    } else {
                                        if ((_e131.member_1 & 32u) != 0u) {
                                            let _e676 = nodes.member[_e563];
                                            let _e690 = nodes.member[_e566];
                                            phi_1340_ = (((((_e676.member_1.y - _e690.member.x) > _e131.member_6) && ((_e690.member_1.y - _e676.member.x) > _e131.member_6)) && (((_e676.member_2.x - _e690.member.y) > _e131.member_6) && ((_e690.member_2.x - _e676.member.y) > _e131.member_6))) && (((_e676.member_2.y - _e690.member_1.x) > _e131.member_6) && ((_e690.member_2.y - _e676.member_1.x) > _e131.member_6)));
                                        } else {
                                            phi_1340_ = true;
                                        }
                                        let _e722 = phi_1340_;
                                        phi_1341_ = _e722;
                                    }
                                    let _e724 = phi_1341_;
                                    phi_1346_ = select(true, false, _e724);
                                }
                                let _e727 = phi_1346_;
                                if _e727 {
                                    let _e729 = leaves.member[_e563];
                                    let _e735 = leaves.member[_e566];
                                    if ((_e131.member_1 & 32u) != 0u) {
                                        let _e744 = nodes.member[_e563];
                                        let _e761 = nodes.member[_e566];
                                        phi_1432_ = array<type_29, 2>(type_29(array<f32, 3>(_e744.member.x, _e744.member.y, _e744.member_1.x), array<f32, 3>(_e744.member_1.y, _e744.member_2.x, _e744.member_2.y)), type_29(array<f32, 3>(_e761.member.x, _e761.member.y, _e761.member_1.x), array<f32, 3>(_e761.member_1.y, _e761.member_2.x, _e761.member_2.y)));
                                    } else {
                                        phi_1432_ = array<type_29, 2>(type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)), type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)));
                                    }
                                    let _e779 = phi_1432_;
                                    if ((_e131.member_1 & 1u) != 0u) {
                                        if (_e134 == 0u) {
                                            phi_1476_ = ((select((_e735.x == _e729.x), true, (_e735.x == _e729.x)) || select((_e735.y == _e729.x), true, (_e735.y == _e729.x))) || select((_e735.z == _e729.x), true, (_e735.z == _e729.x)));
                                        } else {
                                            phi_1476_ = (select((_e735.x == _e729.y), true, (_e735.x == _e729.x)) || select((_e735.y == _e729.y), true, (_e735.y == _e729.x)));
                                        }
                                        let _e803 = phi_1476_;
                                        phi_1477_ = _e803;
                                    } else {
                                        phi_1477_ = false;
                                    }
                                    let _e805 = phi_1477_;
                                    if _e805 {
                                        phi_2402_ = false;
                                        phi_2403_ = true;
                                    } else {
                                        if ((_e131.member_1 & 2u) != 0u) {
                                            let _e810 = bodies.member[_e729.x];
                                            let _e812 = bodies.member[_e735.x];
                                            if select(false, (((_e810 & _e812) & 1u) == 0u), select(select(true, false, ((_e810 & 2u) == 0u)), true, ((_e810 / 4u) != (_e812 / 4u)))) {
                                                if ((_e131.member_1 & 4u) != 0u) {
                                                    let _e830 = bodies.member[_e131.member[0]];
                                                    let _e833 = bodies.member[(_e131.member[0] + 1u)];
                                                    let _e838 = ((_e131.member[0] + 4u) + (2u * (_e810 >> bitcast<u32>(2i))));
                                                    let _e843 = ((_e131.member[0] + 4u) + (2u * (_e812 >> bitcast<u32>(2i))));
                                                    let _e845 = bodies.member[_e838];
                                                    let _e847 = bodies.member[_e843];
                                                    let _e856 = bodies.member[((((_e131.member[0] + 4u) + (2u * _e830)) + (_e845 * _e833)) + (_e847 / 32u))];
                                                    let _e859 = bodies.member[(_e838 + 1u)];
                                                    let _e862 = bodies.member[(_e843 + 1u)];
                                                    if (_e859 == _e862) {
                                                        phi_1641_ = select(((_e810 >> bitcast<u32>(2i)) == (_e812 >> bitcast<u32>(2i))), true, (((_e856 >> bitcast<u32>(((_e847 % 32u) & 31u))) & 1u) == 1u));
                                                    } else {
                                                        phi_1641_ = false;
                                                    }
                                                    let _e877 = phi_1641_;
                                                    if _e877 {
                                                        let _e880 = bodies.member[(_e131.member[0] + 2u)];
                                                        let _e883 = bodies.member[(_e131.member[0] + 3u)];
                                                        let _e884 = (_e883 + _e131.member[0]);
                                                        let _e885 = (_e134 == 1u);
                                                        let _e886 = (_e735.w < _e729.w);
                                                        let _e889 = select(_e735.w, select(_e735.w, _e729.w, _e886), _e885);
                                                        let _e890 = select(_e729.w, select(_e729.w, _e735.w, _e886), _e885);
                                                        phi_1682_ = type_16(0i, 32i);
                                                        phi_1685_ = 0u;
                                                        loop {
                                                            let _e892 = phi_1682_;
                                                            let _e894 = phi_1685_;
                                                            local_2 = _e894;
                                                            local_3 = _e894;
                                                            if (_e892.member < _e892.member_1) {
                                                                let _e901 = (_e892.member + 1i);
                                                                phi_1683_ = type_16(select(_e901, type_17().member_1, select(false, true, ((false == (_e901 > _e892.member)) != false))), _e892.member_1);
                                                                phi_1726_ = type_17(1u, _e892.member);
                                                            } else {
                                                                phi_1683_ = _e892;
                                                                phi_1726_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e912 = phi_1683_;
                                                            let _e914 = phi_1726_;
                                                            let _e918 = (bitcast<i32>(_e914.member) != 0i);
                                                            if _e918 {
                                                                let _e923 = (_e894 | (1u << bitcast<u32>(((31i - _e914.member_1) & 31i))));
                                                                if (_e923 <= _e880) {
                                                                    let _e927 = (_e884 + (3u * (_e923 - 1u)));
                                                                    let _e929 = bodies.member[_e927];
                                                                    let _e932 = bodies.member[(_e927 + 1u)];
                                                                    let _e935 = bodies.member[(_e927 + 2u)];
                                                                    phi_1805_ = select(_e894, _e923, select(select(false, select(select(false, (_e935 < _e889), (_e932 == _e890)), true, (_e932 < _e890)), (_e929 == _e134)), true, (_e929 < _e134)));
                                                                } else {
                                                                    phi_1805_ = _e894;
                                                                }
                                                                let _e947 = phi_1805_;
                                                                phi_1686_ = _e947;
                                                            } else {
                                                                phi_1686_ = u32();
                                                            }
                                                            let _e949 = phi_1686_;
                                                            continue;
                                                            continuing {
                                                                phi_1682_ = _e912;
                                                                phi_1685_ = _e949;
                                                                break if !(_e918);
                                                            }
                                                        }
                                                        let _e952 = local_2;
                                                        if (_e952 < _e880) {
                                                            let _e955 = local_3;
                                                            let _e957 = (_e884 + (3u * _e955));
                                                            let _e959 = bodies.member[_e957];
                                                            if (_e959 == _e134) {
                                                                let _e963 = bodies.member[(_e957 + 1u)];
                                                                if (_e963 == _e890) {
                                                                    let _e967 = bodies.member[(_e957 + 2u)];
                                                                    phi_1853_ = (_e967 == _e889);
                                                                    phi_1854_ = false;
                                                                } else {
                                                                    phi_1853_ = bool();
                                                                    phi_1854_ = true;
                                                                }
                                                                let _e970 = phi_1853_;
                                                                let _e972 = phi_1854_;
                                                                phi_1855_ = _e970;
                                                                phi_1856_ = _e972;
                                                            } else {
                                                                phi_1855_ = bool();
                                                                phi_1856_ = true;
                                                            }
                                                            let _e974 = phi_1855_;
                                                            let _e976 = phi_1856_;
                                                            phi_1861_ = select(_e974, false, _e976);
                                                        } else {
                                                            phi_1861_ = false;
                                                        }
                                                        let _e979 = phi_1861_;
                                                        phi_1865_ = _e979;
                                                    } else {
                                                        phi_1865_ = true;
                                                    }
                                                    let _e981 = phi_1865_;
                                                    phi_1870_ = select(true, false, _e981);
                                                } else {
                                                    phi_1870_ = true;
                                                }
                                                let _e984 = phi_1870_;
                                                phi_1875_ = select(true, false, _e984);
                                            } else {
                                                phi_1875_ = true;
                                            }
                                            let _e987 = phi_1875_;
                                            phi_1880_ = select(true, false, _e987);
                                        } else {
                                            phi_1880_ = true;
                                        }
                                        let _e990 = phi_1880_;
                                        if _e990 {
                                            if ((_e131.member_1 & 32u) != 0u) {
                                                let _e1047 = (((((_e779[0].member_1[0] - _e779[1].member[0]) > _e131.member_6) && ((_e779[1].member_1[0] - _e779[0].member[0]) > _e131.member_6)) && (((_e779[0].member_1[1] - _e779[1].member[1]) > _e131.member_6) && ((_e779[1].member_1[1] - _e779[0].member[1]) > _e131.member_6))) && (((_e779[0].member_1[2] - _e779[1].member[2]) > _e131.member_6) && ((_e779[1].member_1[2] - _e779[0].member[2]) > _e131.member_6)));
                                                if _e1047 {
                                                    phi_2393_ = bool();
                                                } else {
                                                    phi_1925_ = type_9(0u, 3u);
                                                    loop {
                                                        let _e1049 = phi_1925_;
                                                        let _e1052 = (_e1049.member < _e1049.member_1);
                                                        let _e1063 = select(type_9().member_1, _e1049.member, _e1052);
                                                        if (bitcast<i32>(select(0u, 1u, _e1052)) != 0i) {
                                                            let _e1067 = ((6u * _e729.x) + _e1063);
                                                            let _e1070 = keys.member[(2u * _e1067)];
                                                            let _e1074 = keys.member[((2u * _e1067) + 1u)];
                                                            let _e1077 = ((6u * _e729.y) + _e1063);
                                                            let _e1080 = keys.member[(2u * _e1077)];
                                                            let _e1084 = keys.member[((2u * _e1077) + 1u)];
                                                            let _e1086 = function_1(array<u32, 2>(_e1070, _e1074), array<u32, 2>(_e1080, _e1084));
                                                            let _e1088 = ((6u * _e729.z) + _e1063);
                                                            let _e1091 = keys.member[(2u * _e1088)];
                                                            let _e1095 = keys.member[((2u * _e1088) + 1u)];
                                                            let _e1097 = function_1(_e1086, array<u32, 2>(_e1091, _e1095));
                                                            let _e1100 = (((6u * _e735.x) + 3u) + _e1063);
                                                            let _e1103 = keys.member[(2u * _e1100)];
                                                            let _e1107 = keys.member[((2u * _e1100) + 1u)];
                                                            let _e1111 = (((6u * _e735.y) + 3u) + _e1063);
                                                            let _e1114 = keys.member[(2u * _e1111)];
                                                            let _e1118 = keys.member[((2u * _e1111) + 1u)];
                                                            let _e1120 = function_(array<u32, 2>(_e1103, _e1107), array<u32, 2>(_e1114, _e1118));
                                                            let _e1123 = (((6u * _e735.z) + 3u) + _e1063);
                                                            let _e1126 = keys.member[(2u * _e1123)];
                                                            let _e1130 = keys.member[((2u * _e1123) + 1u)];
                                                            let _e1132 = function_(_e1120, array<u32, 2>(_e1126, _e1130));
                                                            let _e1143 = select(select(false, (_e1097[0] > _e1132[0]), (_e1097[1] == _e1132[1])), true, (_e1097[1] > _e1132[1]));
                                                            if _e1143 {
                                                                phi_2372_ = false;
                                                                phi_2373_ = false;
                                                            } else {
                                                                let _e1145 = ((6u * _e735.x) + _e1063);
                                                                let _e1148 = keys.member[(2u * _e1145)];
                                                                let _e1152 = keys.member[((2u * _e1145) + 1u)];
                                                                let _e1155 = ((6u * _e735.y) + _e1063);
                                                                let _e1158 = keys.member[(2u * _e1155)];
                                                                let _e1162 = keys.member[((2u * _e1155) + 1u)];
                                                                let _e1164 = function_1(array<u32, 2>(_e1148, _e1152), array<u32, 2>(_e1158, _e1162));
                                                                let _e1166 = ((6u * _e735.z) + _e1063);
                                                                let _e1169 = keys.member[(2u * _e1166)];
                                                                let _e1173 = keys.member[((2u * _e1166) + 1u)];
                                                                let _e1175 = function_1(_e1164, array<u32, 2>(_e1169, _e1173));
                                                                let _e1178 = (((6u * _e729.x) + 3u) + _e1063);
                                                                let _e1181 = keys.member[(2u * _e1178)];
                                                                let _e1185 = keys.member[((2u * _e1178) + 1u)];
                                                                let _e1189 = (((6u * _e729.y) + 3u) + _e1063);
                                                                let _e1192 = keys.member[(2u * _e1189)];
                                                                let _e1196 = keys.member[((2u * _e1189) + 1u)];
                                                                let _e1198 = function_(array<u32, 2>(_e1181, _e1185), array<u32, 2>(_e1192, _e1196));
                                                                let _e1201 = (((6u * _e729.z) + 3u) + _e1063);
                                                                let _e1204 = keys.member[(2u * _e1201)];
                                                                let _e1208 = keys.member[((2u * _e1201) + 1u)];
                                                                let _e1210 = function_(_e1198, array<u32, 2>(_e1204, _e1208));
                                                                let _e1221 = select(select(false, (_e1175[0] > _e1210[0]), (_e1175[1] == _e1210[1])), true, (_e1175[1] > _e1210[1]));
                                                                phi_2372_ = select(true, false, _e1221);
                                                                phi_2373_ = _e1221;
                                                            }
                                                            let _e1224 = phi_2372_;
                                                            let _e1226 = phi_2373_;
                                                            phi_2374_ = _e1224;
                                                            phi_2375_ = _e1143;
                                                            phi_2376_ = _e1226;
                                                        } else {
                                                            phi_2374_ = false;
                                                            phi_2375_ = false;
                                                            phi_2376_ = false;
                                                        }
                                                        let _e1228 = phi_2374_;
                                                        let _e1230 = phi_2375_;
                                                        let _e1232 = phi_2376_;
                                                        local_4 = _e1230;
                                                        local_5 = _e1232;
                                                        local_6 = _e1230;
                                                        continue;
                                                        continuing {
                                                            phi_1925_ = type_9(select(_e1049.member, (_e1049.member + 1u), _e1052), select(_e1049.member_1, _e1049.member_1, _e1052));
                                                            break if !(_e1228);
                                                        }
                                                    }
                                                    let _e1235 = local_4;
                                                    let _e1237 = local_5;
                                                    let _e1240 = local_6;
                                                    phi_2393_ = select(false, true, select(true, false, select(_e1240, true, select(_e1237, false, _e1235))));
                                                }
                                                let _e1245 = phi_2393_;
                                                phi_2394_ = _e1245;
                                                phi_2395_ = _e1047;
                                            } else {
                                                phi_2394_ = bool();
                                                phi_2395_ = true;
                                            }
                                            let _e1247 = phi_2394_;
                                            let _e1249 = phi_2395_;
                                            phi_2400_ = _e1247;
                                            phi_2401_ = select(true, false, _e1249);
                                        } else {
                                            phi_2400_ = false;
                                            phi_2401_ = true;
                                        }
                                        let _e1252 = phi_2400_;
                                        let _e1254 = phi_2401_;
                                        phi_2402_ = _e1252;
                                        phi_2403_ = _e1254;
                                    }
                                    let _e1256 = phi_2402_;
                                    let _e1258 = phi_2403_;
                                    let _e1259 = select(true, _e1256, _e1258);
                                    if _e1259 {
                                    } else {
                                        let _e1261 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_2424_ = select(_e536, select(_e536, (_e536 | (1u << bitcast<u32>((_e550 & 31u)))), _e668), _e1259);
                                } else {
                                    phi_2424_ = _e536;
                                }
                                let _e1269 = phi_2424_;
                                phi_2425_ = _e1269;
                                phi_2426_ = true;
                            }
                            let _e1271 = phi_2425_;
                            let _e1273 = phi_2426_;
                            phi_1063_ = _e1271;
                            phi_2427_ = _e1273;
                        } else {
                            phi_1063_ = u32();
                            phi_2427_ = false;
                        }
                        let _e1275 = phi_1063_;
                        let _e1277 = phi_2427_;
                        continue;
                        continuing {
                            phi_1059_ = type_9(select(_e534.member, (_e534.member + 1u), _e539), select(_e534.member_1, _e534.member_1, _e539));
                            phi_1062_ = _e1275;
                            break if !(_e1277);
                        }
                    }
                    let _e1281 = params.member.member_1.member_3;
                    let _e1283 = local_7;
                    let _e1286 = atomicAdd((&counters[5u]), countOneBits(_e1283));
                    workgroupBarrier();
                    if (_e57 == 0u) {
                        let _e1289 = atomicLoad((&counters[5u]));
                        if (_e1289 > 0u) {
                            let _e1293 = params.member.member.member_1;
                            if ((_e1293 & 1024u) != 0u) {
                                let _e1303 = atomicAdd((&output.member[0u]), _e1289);
                                let _e1304 = (_e1303 + _e1289);
                                let _e1306 = select(_e1304, 4294967295u, (_e1304 < _e1303));
                                let _e1309 = params.member.member_1.member_3;
                                if (_e1306 > _e1309) {
                                    let _e1312 = atomicMax((&output.member[2u]), _e1306);
                                }
                                phi_2486_ = _e1303;
                            } else {
                                let _e1297 = atomicAdd((&output.member[0u]), _e1289);
                                if ((_e1297 + _e1289) < _e1297) {
                                    let _e1301 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2486_ = _e1297;
                            }
                            let _e1314 = phi_2486_;
                            atomicStore((&counters[6u]), _e1314);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1318 = atomicLoad((&counters[6u]));
                    let _e1320 = (_e532 / 128u);
                    phi_2510_ = type_9(0u, select(_e1320, (_e1320 + 1u), ((_e532 % 128u) > 0u)));
                    phi_2513_ = (_e1286 + _e1318);
                    loop {
                        let _e1327 = phi_2510_;
                        let _e1329 = phi_2513_;
                        let _e1332 = (_e1327.member < _e1327.member_1);
                        let _e1343 = select(type_9().member_1, _e1327.member, _e1332);
                        let _e1345 = (bitcast<i32>(select(0u, 1u, _e1332)) != 0i);
                        if _e1345 {
                            let _e1348 = local_8;
                            if (((_e1348 >> bitcast<u32>((_e1343 & 31u))) & 1u) == 1u) {
                                let _e1356 = hits[(_e57 + (_e1343 * 128u))];
                                let _e1359 = rows[(_e1356 / 4096u)];
                                let _e1365 = names[(_e1356 % 128u)];
                                let _e1367 = leaves.member[(_e1359 + ((_e1356 / 128u) % 32u))];
                                let _e1370 = leaves.member[_e1365];
                                if (_e134 == 1u) {
                                    let _e1374 = (_e1367.w < _e1370.w);
                                    phi_2602_ = type_9(select(_e1370.w, _e1367.w, _e1374), select(_e1367.w, _e1370.w, _e1374));
                                } else {
                                    phi_2602_ = type_9(_e1367.w, _e1370.w);
                                }
                                let _e1379 = phi_2602_;
                                if (_e1329 < _e1281) {
                                    let _e1383 = (2u * _e1329);
                                    atomicStore((&output.member[(4u + _e1383)]), _e1379.member);
                                    atomicStore((&output.member[(_e1383 + 5u)]), _e1379.member_1);
                                }
                                phi_2617_ = (_e1329 + 1u);
                            } else {
                                phi_2617_ = _e1329;
                            }
                            let _e1390 = phi_2617_;
                            phi_2514_ = _e1390;
                        } else {
                            phi_2514_ = u32();
                        }
                        let _e1392 = phi_2514_;
                        continue;
                        continuing {
                            phi_2510_ = type_9(select(_e1327.member, (_e1327.member + 1u), _e1332), select(_e1327.member_1, _e1327.member_1, _e1332));
                            phi_2513_ = _e1392;
                            break if !(_e1345);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_893_ = type_9(select(_e436.member, (_e436.member + 1u), _e439), select(_e436.member_1, _e436.member_1, _e439));
                    break if !(_e452);
                }
            }
            phi_346_ = (_e148 + (_e56.x * _e56.y));
        } else {
            phi_346_ = u32();
        }
        let _e1396 = phi_346_;
        continue;
        continuing {
            phi_345_ = _e1396;
            break if !(_e154);
        }
    }
    if (_e57 == 0u) {
        let _e1400 = atomicLoad((&counters[7u]));
        if (_e1400 > 0u) {
            let _e1403 = atomicAdd((&output.member[1u]), _e1400);
            if ((_e1403 + _e1400) < _e1403) {
                let _e1407 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_wanted(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
