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
    var phi_1470_: bool;
    var phi_1634_: bool;
    var phi_1675_: type_16;
    var phi_1678_: u32;
    var phi_1676_: type_16;
    var phi_1719_: type_17;
    var phi_1798_: u32;
    var phi_1679_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1854_: bool;
    var phi_1858_: bool;
    var phi_1863_: bool;
    var phi_1868_: bool;
    var phi_1873_: bool;
    var phi_1918_: type_9;
    var phi_2365_: bool;
    var phi_2366_: bool;
    var phi_2367_: bool;
    var phi_2368_: bool;
    var phi_2369_: bool;
    var local_4: bool;
    var local_5: bool;
    var local_6: bool;
    var phi_2386_: bool;
    var phi_2387_: bool;
    var phi_2388_: bool;
    var phi_2393_: bool;
    var phi_2394_: bool;
    var phi_2395_: bool;
    var phi_2396_: bool;
    var phi_2417_: u32;
    var phi_2418_: u32;
    var phi_2419_: bool;
    var phi_1063_: u32;
    var phi_2420_: bool;
    var local_7: u32;
    var phi_2479_: u32;
    var phi_2503_: type_9;
    var phi_2506_: u32;
    var local_8: u32;
    var phi_2595_: type_9;
    var phi_2610_: u32;
    var phi_2507_: u32;
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
                                phi_2418_ = u32();
                                phi_2419_ = false;
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
                                    if (_e134 == 0u) {
                                        phi_1470_ = ((select((_e735.x == _e729.x), true, (_e735.x == _e729.x)) || select((_e735.y == _e729.x), true, (_e735.y == _e729.x))) || select((_e735.z == _e729.x), true, (_e735.z == _e729.x)));
                                    } else {
                                        phi_1470_ = (select((_e735.x == _e729.y), true, (_e735.x == _e729.x)) || select((_e735.y == _e729.y), true, (_e735.y == _e729.x)));
                                    }
                                    let _e800 = phi_1470_;
                                    if _e800 {
                                        phi_2395_ = false;
                                        phi_2396_ = true;
                                    } else {
                                        if ((_e131.member_1 & 2u) != 0u) {
                                            let _e805 = bodies.member[_e729.x];
                                            let _e807 = bodies.member[_e735.x];
                                            if select(false, (((_e805 & _e807) & 1u) == 0u), select(select(true, false, ((_e805 & 2u) == 0u)), true, ((_e805 / 4u) != (_e807 / 4u)))) {
                                                if ((_e131.member_1 & 4u) != 0u) {
                                                    let _e825 = bodies.member[_e131.member[0]];
                                                    let _e828 = bodies.member[(_e131.member[0] + 1u)];
                                                    let _e833 = ((_e131.member[0] + 4u) + (2u * (_e805 >> bitcast<u32>(2i))));
                                                    let _e838 = ((_e131.member[0] + 4u) + (2u * (_e807 >> bitcast<u32>(2i))));
                                                    let _e840 = bodies.member[_e833];
                                                    let _e842 = bodies.member[_e838];
                                                    let _e851 = bodies.member[((((_e131.member[0] + 4u) + (2u * _e825)) + (_e840 * _e828)) + (_e842 / 32u))];
                                                    let _e854 = bodies.member[(_e833 + 1u)];
                                                    let _e857 = bodies.member[(_e838 + 1u)];
                                                    if (_e854 == _e857) {
                                                        phi_1634_ = select(((_e805 >> bitcast<u32>(2i)) == (_e807 >> bitcast<u32>(2i))), true, (((_e851 >> bitcast<u32>(((_e842 % 32u) & 31u))) & 1u) == 1u));
                                                    } else {
                                                        phi_1634_ = false;
                                                    }
                                                    let _e872 = phi_1634_;
                                                    if _e872 {
                                                        let _e875 = bodies.member[(_e131.member[0] + 2u)];
                                                        let _e878 = bodies.member[(_e131.member[0] + 3u)];
                                                        let _e879 = (_e878 + _e131.member[0]);
                                                        let _e880 = (_e134 == 1u);
                                                        let _e881 = (_e735.w < _e729.w);
                                                        let _e884 = select(_e735.w, select(_e735.w, _e729.w, _e881), _e880);
                                                        let _e885 = select(_e729.w, select(_e729.w, _e735.w, _e881), _e880);
                                                        phi_1675_ = type_16(0i, 32i);
                                                        phi_1678_ = 0u;
                                                        loop {
                                                            let _e887 = phi_1675_;
                                                            let _e889 = phi_1678_;
                                                            local_2 = _e889;
                                                            local_3 = _e889;
                                                            if (_e887.member < _e887.member_1) {
                                                                let _e896 = (_e887.member + 1i);
                                                                phi_1676_ = type_16(select(_e896, type_17().member_1, select(false, true, ((false == (_e896 > _e887.member)) != false))), _e887.member_1);
                                                                phi_1719_ = type_17(1u, _e887.member);
                                                            } else {
                                                                phi_1676_ = _e887;
                                                                phi_1719_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e907 = phi_1676_;
                                                            let _e909 = phi_1719_;
                                                            let _e913 = (bitcast<i32>(_e909.member) != 0i);
                                                            if _e913 {
                                                                let _e918 = (_e889 | (1u << bitcast<u32>(((31i - _e909.member_1) & 31i))));
                                                                if (_e918 <= _e875) {
                                                                    let _e922 = (_e879 + (3u * (_e918 - 1u)));
                                                                    let _e924 = bodies.member[_e922];
                                                                    let _e927 = bodies.member[(_e922 + 1u)];
                                                                    let _e930 = bodies.member[(_e922 + 2u)];
                                                                    phi_1798_ = select(_e889, _e918, select(select(false, select(select(false, (_e930 < _e884), (_e927 == _e885)), true, (_e927 < _e885)), (_e924 == _e134)), true, (_e924 < _e134)));
                                                                } else {
                                                                    phi_1798_ = _e889;
                                                                }
                                                                let _e942 = phi_1798_;
                                                                phi_1679_ = _e942;
                                                            } else {
                                                                phi_1679_ = u32();
                                                            }
                                                            let _e944 = phi_1679_;
                                                            continue;
                                                            continuing {
                                                                phi_1675_ = _e907;
                                                                phi_1678_ = _e944;
                                                                break if !(_e913);
                                                            }
                                                        }
                                                        let _e947 = local_2;
                                                        if (_e947 < _e875) {
                                                            let _e950 = local_3;
                                                            let _e952 = (_e879 + (3u * _e950));
                                                            let _e954 = bodies.member[_e952];
                                                            if (_e954 == _e134) {
                                                                let _e958 = bodies.member[(_e952 + 1u)];
                                                                if (_e958 == _e885) {
                                                                    let _e962 = bodies.member[(_e952 + 2u)];
                                                                    phi_1846_ = (_e962 == _e884);
                                                                    phi_1847_ = false;
                                                                } else {
                                                                    phi_1846_ = bool();
                                                                    phi_1847_ = true;
                                                                }
                                                                let _e965 = phi_1846_;
                                                                let _e967 = phi_1847_;
                                                                phi_1848_ = _e965;
                                                                phi_1849_ = _e967;
                                                            } else {
                                                                phi_1848_ = bool();
                                                                phi_1849_ = true;
                                                            }
                                                            let _e969 = phi_1848_;
                                                            let _e971 = phi_1849_;
                                                            phi_1854_ = select(_e969, false, _e971);
                                                        } else {
                                                            phi_1854_ = false;
                                                        }
                                                        let _e974 = phi_1854_;
                                                        phi_1858_ = _e974;
                                                    } else {
                                                        phi_1858_ = true;
                                                    }
                                                    let _e976 = phi_1858_;
                                                    phi_1863_ = select(true, false, _e976);
                                                } else {
                                                    phi_1863_ = true;
                                                }
                                                let _e979 = phi_1863_;
                                                phi_1868_ = select(true, false, _e979);
                                            } else {
                                                phi_1868_ = true;
                                            }
                                            let _e982 = phi_1868_;
                                            phi_1873_ = select(true, false, _e982);
                                        } else {
                                            phi_1873_ = true;
                                        }
                                        let _e985 = phi_1873_;
                                        if _e985 {
                                            if ((_e131.member_1 & 32u) != 0u) {
                                                let _e1042 = (((((_e779[0].member_1[0] - _e779[1].member[0]) > _e131.member_6) && ((_e779[1].member_1[0] - _e779[0].member[0]) > _e131.member_6)) && (((_e779[0].member_1[1] - _e779[1].member[1]) > _e131.member_6) && ((_e779[1].member_1[1] - _e779[0].member[1]) > _e131.member_6))) && (((_e779[0].member_1[2] - _e779[1].member[2]) > _e131.member_6) && ((_e779[1].member_1[2] - _e779[0].member[2]) > _e131.member_6)));
                                                if _e1042 {
                                                    phi_2386_ = bool();
                                                } else {
                                                    phi_1918_ = type_9(0u, 3u);
                                                    loop {
                                                        let _e1044 = phi_1918_;
                                                        let _e1047 = (_e1044.member < _e1044.member_1);
                                                        let _e1058 = select(type_9().member_1, _e1044.member, _e1047);
                                                        if (bitcast<i32>(select(0u, 1u, _e1047)) != 0i) {
                                                            let _e1062 = ((6u * _e729.x) + _e1058);
                                                            let _e1065 = keys.member[(2u * _e1062)];
                                                            let _e1069 = keys.member[((2u * _e1062) + 1u)];
                                                            let _e1072 = ((6u * _e729.y) + _e1058);
                                                            let _e1075 = keys.member[(2u * _e1072)];
                                                            let _e1079 = keys.member[((2u * _e1072) + 1u)];
                                                            let _e1081 = function_1(array<u32, 2>(_e1065, _e1069), array<u32, 2>(_e1075, _e1079));
                                                            let _e1083 = ((6u * _e729.z) + _e1058);
                                                            let _e1086 = keys.member[(2u * _e1083)];
                                                            let _e1090 = keys.member[((2u * _e1083) + 1u)];
                                                            let _e1092 = function_1(_e1081, array<u32, 2>(_e1086, _e1090));
                                                            let _e1095 = (((6u * _e735.x) + 3u) + _e1058);
                                                            let _e1098 = keys.member[(2u * _e1095)];
                                                            let _e1102 = keys.member[((2u * _e1095) + 1u)];
                                                            let _e1106 = (((6u * _e735.y) + 3u) + _e1058);
                                                            let _e1109 = keys.member[(2u * _e1106)];
                                                            let _e1113 = keys.member[((2u * _e1106) + 1u)];
                                                            let _e1115 = function_(array<u32, 2>(_e1098, _e1102), array<u32, 2>(_e1109, _e1113));
                                                            let _e1118 = (((6u * _e735.z) + 3u) + _e1058);
                                                            let _e1121 = keys.member[(2u * _e1118)];
                                                            let _e1125 = keys.member[((2u * _e1118) + 1u)];
                                                            let _e1127 = function_(_e1115, array<u32, 2>(_e1121, _e1125));
                                                            let _e1138 = select(select(false, (_e1092[0] > _e1127[0]), (_e1092[1] == _e1127[1])), true, (_e1092[1] > _e1127[1]));
                                                            if _e1138 {
                                                                phi_2365_ = false;
                                                                phi_2366_ = false;
                                                            } else {
                                                                let _e1140 = ((6u * _e735.x) + _e1058);
                                                                let _e1143 = keys.member[(2u * _e1140)];
                                                                let _e1147 = keys.member[((2u * _e1140) + 1u)];
                                                                let _e1150 = ((6u * _e735.y) + _e1058);
                                                                let _e1153 = keys.member[(2u * _e1150)];
                                                                let _e1157 = keys.member[((2u * _e1150) + 1u)];
                                                                let _e1159 = function_1(array<u32, 2>(_e1143, _e1147), array<u32, 2>(_e1153, _e1157));
                                                                let _e1161 = ((6u * _e735.z) + _e1058);
                                                                let _e1164 = keys.member[(2u * _e1161)];
                                                                let _e1168 = keys.member[((2u * _e1161) + 1u)];
                                                                let _e1170 = function_1(_e1159, array<u32, 2>(_e1164, _e1168));
                                                                let _e1173 = (((6u * _e729.x) + 3u) + _e1058);
                                                                let _e1176 = keys.member[(2u * _e1173)];
                                                                let _e1180 = keys.member[((2u * _e1173) + 1u)];
                                                                let _e1184 = (((6u * _e729.y) + 3u) + _e1058);
                                                                let _e1187 = keys.member[(2u * _e1184)];
                                                                let _e1191 = keys.member[((2u * _e1184) + 1u)];
                                                                let _e1193 = function_(array<u32, 2>(_e1176, _e1180), array<u32, 2>(_e1187, _e1191));
                                                                let _e1196 = (((6u * _e729.z) + 3u) + _e1058);
                                                                let _e1199 = keys.member[(2u * _e1196)];
                                                                let _e1203 = keys.member[((2u * _e1196) + 1u)];
                                                                let _e1205 = function_(_e1193, array<u32, 2>(_e1199, _e1203));
                                                                let _e1216 = select(select(false, (_e1170[0] > _e1205[0]), (_e1170[1] == _e1205[1])), true, (_e1170[1] > _e1205[1]));
                                                                phi_2365_ = select(true, false, _e1216);
                                                                phi_2366_ = _e1216;
                                                            }
                                                            let _e1219 = phi_2365_;
                                                            let _e1221 = phi_2366_;
                                                            phi_2367_ = _e1219;
                                                            phi_2368_ = _e1138;
                                                            phi_2369_ = _e1221;
                                                        } else {
                                                            phi_2367_ = false;
                                                            phi_2368_ = false;
                                                            phi_2369_ = false;
                                                        }
                                                        let _e1223 = phi_2367_;
                                                        let _e1225 = phi_2368_;
                                                        let _e1227 = phi_2369_;
                                                        local_4 = _e1225;
                                                        local_5 = _e1227;
                                                        local_6 = _e1225;
                                                        continue;
                                                        continuing {
                                                            phi_1918_ = type_9(select(_e1044.member, (_e1044.member + 1u), _e1047), select(_e1044.member_1, _e1044.member_1, _e1047));
                                                            break if !(_e1223);
                                                        }
                                                    }
                                                    let _e1230 = local_4;
                                                    let _e1232 = local_5;
                                                    let _e1235 = local_6;
                                                    phi_2386_ = select(false, true, select(true, false, select(_e1235, true, select(_e1232, false, _e1230))));
                                                }
                                                let _e1240 = phi_2386_;
                                                phi_2387_ = _e1240;
                                                phi_2388_ = _e1042;
                                            } else {
                                                phi_2387_ = bool();
                                                phi_2388_ = true;
                                            }
                                            let _e1242 = phi_2387_;
                                            let _e1244 = phi_2388_;
                                            phi_2393_ = _e1242;
                                            phi_2394_ = select(true, false, _e1244);
                                        } else {
                                            phi_2393_ = false;
                                            phi_2394_ = true;
                                        }
                                        let _e1247 = phi_2393_;
                                        let _e1249 = phi_2394_;
                                        phi_2395_ = _e1247;
                                        phi_2396_ = _e1249;
                                    }
                                    let _e1251 = phi_2395_;
                                    let _e1253 = phi_2396_;
                                    let _e1254 = select(true, _e1251, _e1253);
                                    if _e1254 {
                                    } else {
                                        let _e1256 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_2417_ = select(_e536, select(_e536, (_e536 | (1u << bitcast<u32>((_e550 & 31u)))), _e668), _e1254);
                                } else {
                                    phi_2417_ = _e536;
                                }
                                let _e1264 = phi_2417_;
                                phi_2418_ = _e1264;
                                phi_2419_ = true;
                            }
                            let _e1266 = phi_2418_;
                            let _e1268 = phi_2419_;
                            phi_1063_ = _e1266;
                            phi_2420_ = _e1268;
                        } else {
                            phi_1063_ = u32();
                            phi_2420_ = false;
                        }
                        let _e1270 = phi_1063_;
                        let _e1272 = phi_2420_;
                        continue;
                        continuing {
                            phi_1059_ = type_9(select(_e534.member, (_e534.member + 1u), _e539), select(_e534.member_1, _e534.member_1, _e539));
                            phi_1062_ = _e1270;
                            break if !(_e1272);
                        }
                    }
                    let _e1276 = params.member.member_1.member_3;
                    let _e1278 = local_7;
                    let _e1281 = atomicAdd((&counters[5u]), countOneBits(_e1278));
                    workgroupBarrier();
                    if (_e57 == 0u) {
                        let _e1284 = atomicLoad((&counters[5u]));
                        if (_e1284 > 0u) {
                            let _e1288 = params.member.member.member_1;
                            if ((_e1288 & 1024u) != 0u) {
                                let _e1298 = atomicAdd((&output.member[0u]), _e1284);
                                let _e1299 = (_e1298 + _e1284);
                                let _e1301 = select(_e1299, 4294967295u, (_e1299 < _e1298));
                                let _e1304 = params.member.member_1.member_3;
                                if (_e1301 > _e1304) {
                                    let _e1307 = atomicMax((&output.member[2u]), _e1301);
                                }
                                phi_2479_ = _e1298;
                            } else {
                                let _e1292 = atomicAdd((&output.member[0u]), _e1284);
                                if ((_e1292 + _e1284) < _e1292) {
                                    let _e1296 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2479_ = _e1292;
                            }
                            let _e1309 = phi_2479_;
                            atomicStore((&counters[6u]), _e1309);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1313 = atomicLoad((&counters[6u]));
                    let _e1315 = (_e532 / 128u);
                    phi_2503_ = type_9(0u, select(_e1315, (_e1315 + 1u), ((_e532 % 128u) > 0u)));
                    phi_2506_ = (_e1281 + _e1313);
                    loop {
                        let _e1322 = phi_2503_;
                        let _e1324 = phi_2506_;
                        let _e1327 = (_e1322.member < _e1322.member_1);
                        let _e1338 = select(type_9().member_1, _e1322.member, _e1327);
                        let _e1340 = (bitcast<i32>(select(0u, 1u, _e1327)) != 0i);
                        if _e1340 {
                            let _e1343 = local_8;
                            if (((_e1343 >> bitcast<u32>((_e1338 & 31u))) & 1u) == 1u) {
                                let _e1351 = hits[(_e57 + (_e1338 * 128u))];
                                let _e1354 = rows[(_e1351 / 4096u)];
                                let _e1360 = names[(_e1351 % 128u)];
                                let _e1362 = leaves.member[(_e1354 + ((_e1351 / 128u) % 32u))];
                                let _e1365 = leaves.member[_e1360];
                                if (_e134 == 1u) {
                                    let _e1369 = (_e1362.w < _e1365.w);
                                    phi_2595_ = type_9(select(_e1365.w, _e1362.w, _e1369), select(_e1362.w, _e1365.w, _e1369));
                                } else {
                                    phi_2595_ = type_9(_e1362.w, _e1365.w);
                                }
                                let _e1374 = phi_2595_;
                                if (_e1324 < _e1276) {
                                    let _e1378 = (2u * _e1324);
                                    atomicStore((&output.member[(4u + _e1378)]), _e1374.member);
                                    atomicStore((&output.member[(_e1378 + 5u)]), _e1374.member_1);
                                }
                                phi_2610_ = (_e1324 + 1u);
                            } else {
                                phi_2610_ = _e1324;
                            }
                            let _e1385 = phi_2610_;
                            phi_2507_ = _e1385;
                        } else {
                            phi_2507_ = u32();
                        }
                        let _e1387 = phi_2507_;
                        continue;
                        continuing {
                            phi_2503_ = type_9(select(_e1322.member, (_e1322.member + 1u), _e1327), select(_e1322.member_1, _e1322.member_1, _e1327));
                            phi_2506_ = _e1387;
                            break if !(_e1340);
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
        let _e1391 = phi_346_;
        continue;
        continuing {
            phi_345_ = _e1391;
            break if !(_e154);
        }
    }
    if (_e57 == 0u) {
        let _e1395 = atomicLoad((&counters[7u]));
        if (_e1395 > 0u) {
            let _e1398 = atomicAdd((&output.member[1u]), _e1395);
            if ((_e1398 + _e1395) < _e1398) {
                let _e1402 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_wanted(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
