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
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
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

struct type_36 {
    member: array<vec4<f32>>,
}

struct type_41 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(3) 
var<storage> ends: type_36;
@group(0) @binding(4) 
var<storage> bodies: type_11;
@group(0) @binding(5) 
var<storage> keys: type_11;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_41;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_1[0] > param[0]), (param_1[1] == param[1])), true, (param_1[1] > param[1]));
    return array<u32, 2>(select(param[0], param_1[0], _e14), select(param[1], param_1[1], _e14));
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_2[0] > param_3[0]), (param_2[1] == param_3[1])), true, (param_2[1] > param_3[1]));
    return array<u32, 2>(select(param_2[0], param_3[0], _e14), select(param_2[1], param_3[1], _e14));
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_207_: u32;
    var phi_234_: u32;
    var phi_284_: u32;
    var phi_563_: bool;
    var phi_613_: type_9;
    var phi_616_: u32;
    var phi_617_: u32;
    var local: u32;
    var local_1: u32;
    var phi_950_: type_9;
    var phi_1016_: type_9;
    var phi_1019_: u32;
    var phi_1021_: u32;
    var phi_1023_: u32;
    var phi_1020_: u32;
    var phi_1022_: u32;
    var phi_1024_: u32;
    var phi_1132_: type_9;
    var phi_1135_: u32;
    var phi_1352_: bool;
    var phi_1422_: bool;
    var phi_1423_: bool;
    var phi_1428_: bool;
    var phi_1514_: array<type_29, 2>;
    var phi_1558_: bool;
    var phi_1559_: bool;
    var phi_1723_: bool;
    var phi_1764_: type_15;
    var phi_1767_: u32;
    var phi_1765_: type_15;
    var phi_1808_: type_16;
    var phi_1887_: u32;
    var phi_1768_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1935_: bool;
    var phi_1936_: bool;
    var phi_1937_: bool;
    var phi_1938_: bool;
    var phi_1943_: bool;
    var phi_1947_: bool;
    var phi_1952_: bool;
    var phi_1957_: bool;
    var phi_1962_: bool;
    var phi_2007_: type_9;
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2458_: bool;
    var local_4: bool;
    var local_5: bool;
    var local_6: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2482_: bool;
    var phi_2483_: bool;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2506_: u32;
    var phi_2507_: u32;
    var phi_2508_: bool;
    var phi_1136_: u32;
    var phi_2509_: bool;
    var local_7: u32;
    var phi_2568_: u32;
    var phi_2592_: type_9;
    var phi_2595_: u32;
    var local_8: u32;
    var phi_2693_: type_9;
    var phi_2708_: u32;
    var phi_2596_: u32;
    var phi_285_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e56 = id_2;
    let _e57 = n_2;
    let _e58 = lane_2;
    let _e77 = params.member.member_1.member_2;
    let _e79 = input.member[0u];
    let _e81 = select(_e79, _e77, (_e77 < _e79));
    let _e84 = params.member.member_1.member_1;
    if (_e81 > _e84) {
        let _e88 = params.member.member_1.member_1;
        phi_207_ = (_e81 - _e88);
    } else {
        phi_207_ = 0u;
    }
    let _e91 = phi_207_;
    let _e94 = params.member.member_2.member_3;
    if (_e94 == 1u) {
        phi_234_ = _e91;
    } else {
        let _e98 = params.member.member_2.member_3;
        if (_e98 == 0u) {
            return;
        }
        let _e100 = (_e91 / _e98);
        if (_e98 == 0u) {
            return;
        }
        phi_234_ = select(_e100, (_e100 + 1u), ((_e91 % _e98) > 0u));
    }
    let _e107 = phi_234_;
    let _e110 = params.member.member_2.member_4;
    let _e112 = select(_e107, _e110, (_e110 < _e107));
    let _e114 = params.member.member;
    let _e117 = params.member.member_2.member_1;
    let _e127 = (((_e114.member_5 + (2f * _e114.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
    if (_e58 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    phi_284_ = ((_e56.y * _e57.x) + _e56.x);
    loop {
        let _e131 = phi_284_;
        let _e132 = (_e112 / 4u);
        let _e137 = (_e131 < select(_e132, (_e132 + 1u), ((_e112 % 4u) > 0u)));
        if _e137 {
            let _e140 = ((_e131 * 4u) + (_e58 / 32u));
            let _e141 = (_e140 < _e112);
            let _e144 = params.member.member_1.member_1;
            let _e147 = params.member.member_2.member_3;
            let _e151 = (2u * (_e144 + select(0u, (_e140 * _e147), _e141)));
            let _e154 = input.member[(4u + _e151)];
            let _e157 = input.member[(_e151 + 5u)];
            if (_e58 <= 5u) {
                atomicStore((&counters[_e58]), 0u);
            }
            workgroupBarrier();
            let _e160 = (_e117 == 0u);
            if ((_e58 % 32u) == 0u) {
                let _e166 = (_e58 / 32u);
                let _e172 = params.member.member_2.member[0u][select(1u, 0u, _e160)];
                firsts[(2u * _e166)] = (_e172 + (_e154 * 32u));
                let _e181 = params.member.member_2.member[0u][select(1u, 2u, _e160)];
                firsts[((2u * _e166) + 1u)] = (_e181 + (_e157 * 32u));
            }
            let _e186 = select(false, (_e154 == _e157), (_e117 == 1u));
            let _e189 = params.member.member_2.member_1;
            let _e190 = (_e189 == 0u);
            let _e191 = select(1u, 0u, _e190);
            let _e193 = (_e58 / 32u);
            let _e194 = (_e58 % 32u);
            let _e198 = params.member.member_2.member[1u][_e191];
            let _e201 = nodes.member[(_e198 + _e154)];
            let _e219 = params.member.member_2.member[0u][_e191];
            let _e222 = nodes.member[(_e219 + ((_e154 * 32u) + _e194))];
            let _e240 = params.member.member_2.member[0u][select(1u, 2u, _e190)];
            let _e243 = nodes.member[(_e240 + ((_e157 * 32u) + _e194))];
            if _e141 {
                if _e186 {
                    phi_563_ = true;
                } else {
                    phi_563_ = ((((((_e243.member.x <= _e201.member_1.y) && (_e201.member.x <= _e243.member_1.y)) && (_e243.member.y <= _e201.member_2.x)) && (_e201.member.y <= _e243.member_2.x)) && (_e243.member_1.x <= _e201.member_2.y)) && (_e201.member_1.x <= _e243.member_2.y));
                }
                let _e268 = phi_563_;
                if _e268 {
                    let _e270 = atomicAdd((&counters[_e193]), 1u);
                    let _e273 = ((_e193 * 32u) + select(_e270, _e194, _e186));
                    columns[_e273] = type_29(array<f32, 3>(_e243.member.x, _e243.member.y, _e243.member_1.x), array<f32, 3>(_e243.member_1.y, _e243.member_2.x, _e243.member_2.y));
                    names[_e273] = _e194;
                }
            }
            workgroupBarrier();
            let _e279 = (_e58 / 32u);
            let _e281 = (_e279 * 32u);
            let _e283 = atomicLoad((&counters[_e279]));
            let _e284 = (_e283 / 4u);
            phi_613_ = type_9(0u, select(_e284, (_e284 + 1u), ((_e283 % 4u) > 0u)));
            phi_616_ = 0u;
            loop {
                let _e291 = phi_613_;
                let _e293 = phi_616_;
                local = _e293;
                local_1 = _e293;
                let _e296 = (_e291.member < _e291.member_1);
                let _e309 = (bitcast<i32>(select(0u, 1u, _e296)) != 0i);
                if _e309 {
                    let _e310 = (4u * select(type_9().member_1, _e291.member, _e296));
                    let _e313 = columns[(_e281 + _e310)];
                    let _e337 = columns[((_e281 + _e310) + 1u)];
                    let _e364 = columns[((_e281 + _e310) + 2u)];
                    let _e391 = columns[((_e281 + _e310) + 3u)];
                    phi_617_ = (_e293 | ((((select(0u, 1u, ((((((_e222.member.x <= _e313.member_1[0]) && (_e313.member[0] <= _e222.member_1.y)) && (_e222.member.y <= _e313.member_1[1])) && (_e313.member[1] <= _e222.member_2.x)) && (_e222.member_1.x <= _e313.member_1[2])) && (_e313.member[2] <= _e222.member_2.y))) | (select(0u, 1u, ((((((_e222.member.x <= _e337.member_1[0]) && (_e337.member[0] <= _e222.member_1.y)) && (_e222.member.y <= _e337.member_1[1])) && (_e337.member[1] <= _e222.member_2.x)) && (_e222.member_1.x <= _e337.member_1[2])) && (_e337.member[2] <= _e222.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e222.member.x <= _e364.member_1[0]) && (_e364.member[0] <= _e222.member_1.y)) && (_e222.member.y <= _e364.member_1[1])) && (_e364.member[1] <= _e222.member_2.x)) && (_e222.member_1.x <= _e364.member_1[2])) && (_e364.member[2] <= _e222.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e222.member.x <= _e391.member_1[0]) && (_e391.member[0] <= _e222.member_1.y)) && (_e222.member.y <= _e391.member_1[1])) && (_e391.member[1] <= _e222.member_2.x)) && (_e222.member_1.x <= _e391.member_1[2])) && (_e391.member[2] <= _e222.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e310 & 31u))));
                } else {
                    phi_617_ = u32();
                }
                let _e420 = phi_617_;
                continue;
                continuing {
                    phi_613_ = type_9(select(_e291.member, (_e291.member + 1u), _e296), select(_e291.member_1, _e291.member_1, _e296));
                    phi_616_ = _e420;
                    break if !(_e309);
                }
            }
            let _e428 = local;
            let _e431 = local_1;
            let _e432 = select(_e431, (_e428 & ((1u << bitcast<u32>((_e283 & 31u))) - 1u)), (_e283 < 32u));
            let _e437 = select(_e432, (_e432 & (4294967294u << bitcast<u32>(((_e58 % 32u) & 31u)))), _e186);
            let _e441 = atomicAdd((&counters[4u]), countOneBits(_e437));
            workgroupBarrier();
            if (_e58 == 0u) {
                let _e444 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e444;
            }
            let _e447 = workgroupUniformLoad((&n_hits[0u]));
            let _e448 = (_e447 / 512u);
            if (_e58 == 0u) {
                let _e455 = atomicLoad((&counters[7u]));
                let _e457 = n_hits[0u];
                atomicStore((&counters[7u]), (_e455 + _e457));
            }
            phi_950_ = type_9(0u, select(_e448, (_e448 + 1u), ((_e447 % 512u) > 0u)));
            loop {
                let _e462 = phi_950_;
                let _e465 = (_e462.member < _e462.member_1);
                let _e478 = (bitcast<i32>(select(0u, 1u, _e465)) != 0i);
                if _e478 {
                    let _e479 = (_e58 / 32u);
                    let _e481 = (select(type_9().member_1, _e462.member, _e465) * 512u);
                    if (_e437 == 0u) {
                    } else {
                        let _e490 = atomicLoad((&counters[_e479]));
                        let _e491 = (_e490 / 4u);
                        phi_1016_ = type_9(0u, select(_e491, (_e491 + 1u), ((_e490 % 4u) > 0u)));
                        phi_1019_ = (_e441 - _e481);
                        phi_1021_ = ((_e479 << bitcast<u32>(10i)) | ((_e58 % 32u) << bitcast<u32>(5i)));
                        phi_1023_ = _e437;
                        loop {
                            let _e498 = phi_1016_;
                            let _e500 = phi_1019_;
                            let _e502 = phi_1021_;
                            let _e504 = phi_1023_;
                            let _e507 = (_e498.member < _e498.member_1);
                            let _e518 = (bitcast<i32>(select(0u, 1u, _e507)) != 0i);
                            if _e518 {
                                let _e519 = (_e504 & 1u);
                                if (_e519 == 0u) {
                                } else {
                                    if (_e500 < 512u) {
                                        hits[_e500] = _e502;
                                    }
                                }
                                let _e525 = select((_e500 + 1u), _e500, (_e519 == 0u));
                                let _e526 = (_e504 & 2u);
                                if (_e526 == 0u) {
                                } else {
                                    if (_e525 < 512u) {
                                        hits[_e525] = (_e502 + 1u);
                                    }
                                }
                                let _e533 = select((_e525 + 1u), _e525, (_e526 == 0u));
                                let _e534 = (_e504 & 4u);
                                if (_e534 == 0u) {
                                } else {
                                    if (_e533 < 512u) {
                                        hits[_e533] = (_e502 + 2u);
                                    }
                                }
                                let _e541 = select((_e533 + 1u), _e533, (_e534 == 0u));
                                let _e542 = (_e504 & 8u);
                                if (_e542 == 0u) {
                                } else {
                                    if (_e541 < 512u) {
                                        hits[_e541] = (_e502 + 3u);
                                    }
                                }
                                phi_1020_ = select((_e541 + 1u), _e541, (_e542 == 0u));
                                phi_1022_ = (_e502 + 4u);
                                phi_1024_ = (_e504 >> bitcast<u32>(4i));
                            } else {
                                phi_1020_ = u32();
                                phi_1022_ = u32();
                                phi_1024_ = u32();
                            }
                            let _e554 = phi_1020_;
                            let _e556 = phi_1022_;
                            let _e558 = phi_1024_;
                            continue;
                            continuing {
                                phi_1016_ = type_9(select(_e498.member, (_e498.member + 1u), _e507), select(_e498.member_1, _e498.member_1, _e507));
                                phi_1019_ = _e554;
                                phi_1021_ = _e556;
                                phi_1023_ = _e558;
                                break if !(_e518);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e561 = n_hits[0u];
                    let _e562 = (_e561 - _e481);
                    let _e564 = select(_e562, 512u, (512u < _e562));
                    phi_1132_ = type_9(0u, 4u);
                    phi_1135_ = 0u;
                    loop {
                        let _e566 = phi_1132_;
                        let _e568 = phi_1135_;
                        local_7 = _e568;
                        local_8 = _e568;
                        let _e571 = (_e566.member < _e566.member_1);
                        let _e582 = select(type_9().member_1, _e566.member, _e571);
                        if (bitcast<i32>(select(0u, 1u, _e571)) != 0i) {
                            let _e586 = (_e58 + (_e582 * 128u));
                            if (_e586 >= _e564) {
                                phi_2507_ = u32();
                                phi_2508_ = false;
                            } else {
                                let _e589 = hits[_e586];
                                let _e592 = ((_e589 >> bitcast<u32>(10i)) & 3u);
                                let _e600 = names[((_e592 * 32u) + (_e589 & 31u))];
                                let _e603 = firsts[(2u * _e592)];
                                let _e604 = (_e603 + ((_e589 >> bitcast<u32>(5i)) & 31u));
                                let _e608 = firsts[((2u * _e592) + 1u)];
                                let _e609 = (_e608 + _e600);
                                if ((_e114.member_1 & 512u) != 0u) {
                                    let _e615 = ends.member[(((_e604 / 32u) * 96u) + (_e604 % 32u))];
                                    let _e623 = ends.member[(((((_e604 / 32u) * 3u) + 1u) * 32u) + (_e604 % 32u))];
                                    let _e639 = ends.member[(((((_e604 / 32u) * 3u) + 2u) * 32u) + (_e604 % 32u))];
                                    let _e649 = ends.member[(((_e609 / 32u) * 96u) + (_e609 % 32u))];
                                    let _e657 = ends.member[(((((_e609 / 32u) * 3u) + 1u) * 32u) + (_e609 % 32u))];
                                    let _e673 = ends.member[(((((_e609 / 32u) * 3u) + 2u) * 32u) + (_e609 % 32u))];
                                    phi_1352_ = !(((((((_e615.x - _e649.w) > _e127) && ((_e623.z - _e673.y) > _e127)) || (((_e649.x - _e615.w) > _e127) && ((_e657.z - _e639.y) > _e127))) || ((((_e615.y - _e657.x) > _e127) && ((_e623.w - _e673.z) > _e127)) || (((_e649.y - _e623.x) > _e127) && ((_e657.w - _e639.z) > _e127)))) || ((((_e615.z - _e657.y) > _e127) && ((_e639.x - _e673.w) > _e127)) || (((_e649.z - _e623.y) > _e127) && ((_e673.x - _e639.w) > _e127)))));
                                } else {
                                    phi_1352_ = true;
                                }
                                let _e715 = phi_1352_;
                                if _e715 {
                                    phi_1428_ = true;
                                } else {
                                    if ((_e114.member_1 & 2u) != 0u) {
                                        phi_1423_ = false;
                                    } else {
                                        if ((_e114.member_1 & 32u) != 0u) {
                                            let _e723 = nodes.member[_e604];
                                            let _e737 = nodes.member[_e609];
                                            phi_1422_ = (((((_e723.member_1.y - _e737.member.x) > _e114.member_6) && ((_e737.member_1.y - _e723.member.x) > _e114.member_6)) && (((_e723.member_2.x - _e737.member.y) > _e114.member_6) && ((_e737.member_2.x - _e723.member.y) > _e114.member_6))) && (((_e723.member_2.y - _e737.member_1.x) > _e114.member_6) && ((_e737.member_2.y - _e723.member_1.x) > _e114.member_6)));
                                        } else {
                                            phi_1422_ = true;
                                        }
                                        let _e769 = phi_1422_;
                                        phi_1423_ = _e769;
                                    }
                                    let _e771 = phi_1423_;
                                    phi_1428_ = select(true, false, _e771);
                                }
                                let _e774 = phi_1428_;
                                if _e774 {
                                    let _e776 = leaves.member[_e604];
                                    let _e782 = leaves.member[_e609];
                                    if ((_e114.member_1 & 32u) != 0u) {
                                        let _e791 = nodes.member[_e604];
                                        let _e808 = nodes.member[_e609];
                                        phi_1514_ = array<type_29, 2>(type_29(array<f32, 3>(_e791.member.x, _e791.member.y, _e791.member_1.x), array<f32, 3>(_e791.member_1.y, _e791.member_2.x, _e791.member_2.y)), type_29(array<f32, 3>(_e808.member.x, _e808.member.y, _e808.member_1.x), array<f32, 3>(_e808.member_1.y, _e808.member_2.x, _e808.member_2.y)));
                                    } else {
                                        phi_1514_ = array<type_29, 2>(type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)), type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)));
                                    }
                                    let _e826 = phi_1514_;
                                    if ((_e114.member_1 & 1u) != 0u) {
                                        if (_e117 == 0u) {
                                            phi_1558_ = ((select((_e782.x == _e776.x), true, (_e782.x == _e776.x)) || select((_e782.y == _e776.x), true, (_e782.y == _e776.x))) || select((_e782.z == _e776.x), true, (_e782.z == _e776.x)));
                                        } else {
                                            phi_1558_ = (select((_e782.x == _e776.y), true, (_e782.x == _e776.x)) || select((_e782.y == _e776.y), true, (_e782.y == _e776.x)));
                                        }
                                        let _e850 = phi_1558_;
                                        phi_1559_ = _e850;
                                    } else {
                                        phi_1559_ = false;
                                    }
                                    let _e852 = phi_1559_;
                                    if _e852 {
                                        phi_2484_ = false;
                                        phi_2485_ = true;
                                    } else {
                                        if ((_e114.member_1 & 2u) != 0u) {
                                            let _e857 = bodies.member[_e776.x];
                                            let _e859 = bodies.member[_e782.x];
                                            if select(false, (((_e857 & _e859) & 1u) == 0u), select(select(true, false, ((_e857 & 2u) == 0u)), true, ((_e857 / 4u) != (_e859 / 4u)))) {
                                                if ((_e114.member_1 & 4u) != 0u) {
                                                    let _e877 = bodies.member[_e114.member[0]];
                                                    let _e880 = bodies.member[(_e114.member[0] + 1u)];
                                                    let _e885 = ((_e114.member[0] + 4u) + (2u * (_e857 >> bitcast<u32>(2i))));
                                                    let _e890 = ((_e114.member[0] + 4u) + (2u * (_e859 >> bitcast<u32>(2i))));
                                                    let _e892 = bodies.member[_e885];
                                                    let _e894 = bodies.member[_e890];
                                                    let _e903 = bodies.member[((((_e114.member[0] + 4u) + (2u * _e877)) + (_e892 * _e880)) + (_e894 / 32u))];
                                                    let _e906 = bodies.member[(_e885 + 1u)];
                                                    let _e909 = bodies.member[(_e890 + 1u)];
                                                    if (_e906 == _e909) {
                                                        phi_1723_ = select(((_e857 >> bitcast<u32>(2i)) == (_e859 >> bitcast<u32>(2i))), true, (((_e903 >> bitcast<u32>(((_e894 % 32u) & 31u))) & 1u) == 1u));
                                                    } else {
                                                        phi_1723_ = false;
                                                    }
                                                    let _e924 = phi_1723_;
                                                    if _e924 {
                                                        let _e927 = bodies.member[(_e114.member[0] + 2u)];
                                                        let _e930 = bodies.member[(_e114.member[0] + 3u)];
                                                        let _e931 = (_e930 + _e114.member[0]);
                                                        let _e932 = (_e117 == 1u);
                                                        let _e933 = (_e782.w < _e776.w);
                                                        let _e936 = select(_e782.w, select(_e782.w, _e776.w, _e933), _e932);
                                                        let _e937 = select(_e776.w, select(_e776.w, _e782.w, _e933), _e932);
                                                        phi_1764_ = type_15(0i, 32i);
                                                        phi_1767_ = 0u;
                                                        loop {
                                                            let _e939 = phi_1764_;
                                                            let _e941 = phi_1767_;
                                                            local_2 = _e941;
                                                            local_3 = _e941;
                                                            if (_e939.member < _e939.member_1) {
                                                                let _e948 = (_e939.member + 1i);
                                                                phi_1765_ = type_15(select(_e948, type_16().member_1, select(false, true, ((false == (_e948 > _e939.member)) != false))), _e939.member_1);
                                                                phi_1808_ = type_16(1u, _e939.member);
                                                            } else {
                                                                phi_1765_ = _e939;
                                                                phi_1808_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e959 = phi_1765_;
                                                            let _e961 = phi_1808_;
                                                            let _e965 = (bitcast<i32>(_e961.member) != 0i);
                                                            if _e965 {
                                                                let _e970 = (_e941 | (1u << bitcast<u32>(((31i - _e961.member_1) & 31i))));
                                                                if (_e970 <= _e927) {
                                                                    let _e974 = (_e931 + (3u * (_e970 - 1u)));
                                                                    let _e976 = bodies.member[_e974];
                                                                    let _e979 = bodies.member[(_e974 + 1u)];
                                                                    let _e982 = bodies.member[(_e974 + 2u)];
                                                                    phi_1887_ = select(_e941, _e970, select(select(false, select(select(false, (_e982 < _e936), (_e979 == _e937)), true, (_e979 < _e937)), (_e976 == _e117)), true, (_e976 < _e117)));
                                                                } else {
                                                                    phi_1887_ = _e941;
                                                                }
                                                                let _e994 = phi_1887_;
                                                                phi_1768_ = _e994;
                                                            } else {
                                                                phi_1768_ = u32();
                                                            }
                                                            let _e996 = phi_1768_;
                                                            continue;
                                                            continuing {
                                                                phi_1764_ = _e959;
                                                                phi_1767_ = _e996;
                                                                break if !(_e965);
                                                            }
                                                        }
                                                        let _e999 = local_2;
                                                        if (_e999 < _e927) {
                                                            let _e1002 = local_3;
                                                            let _e1004 = (_e931 + (3u * _e1002));
                                                            let _e1006 = bodies.member[_e1004];
                                                            if (_e1006 == _e117) {
                                                                let _e1010 = bodies.member[(_e1004 + 1u)];
                                                                if (_e1010 == _e937) {
                                                                    let _e1014 = bodies.member[(_e1004 + 2u)];
                                                                    phi_1935_ = (_e1014 == _e936);
                                                                    phi_1936_ = false;
                                                                } else {
                                                                    phi_1935_ = bool();
                                                                    phi_1936_ = true;
                                                                }
                                                                let _e1017 = phi_1935_;
                                                                let _e1019 = phi_1936_;
                                                                phi_1937_ = _e1017;
                                                                phi_1938_ = _e1019;
                                                            } else {
                                                                phi_1937_ = bool();
                                                                phi_1938_ = true;
                                                            }
                                                            let _e1021 = phi_1937_;
                                                            let _e1023 = phi_1938_;
                                                            phi_1943_ = select(_e1021, false, _e1023);
                                                        } else {
                                                            phi_1943_ = false;
                                                        }
                                                        let _e1026 = phi_1943_;
                                                        phi_1947_ = _e1026;
                                                    } else {
                                                        phi_1947_ = true;
                                                    }
                                                    let _e1028 = phi_1947_;
                                                    phi_1952_ = select(true, false, _e1028);
                                                } else {
                                                    phi_1952_ = true;
                                                }
                                                let _e1031 = phi_1952_;
                                                phi_1957_ = select(true, false, _e1031);
                                            } else {
                                                phi_1957_ = true;
                                            }
                                            let _e1034 = phi_1957_;
                                            phi_1962_ = select(true, false, _e1034);
                                        } else {
                                            phi_1962_ = true;
                                        }
                                        let _e1037 = phi_1962_;
                                        if _e1037 {
                                            if ((_e114.member_1 & 32u) != 0u) {
                                                let _e1094 = (((((_e826[0].member_1[0] - _e826[1].member[0]) > _e114.member_6) && ((_e826[1].member_1[0] - _e826[0].member[0]) > _e114.member_6)) && (((_e826[0].member_1[1] - _e826[1].member[1]) > _e114.member_6) && ((_e826[1].member_1[1] - _e826[0].member[1]) > _e114.member_6))) && (((_e826[0].member_1[2] - _e826[1].member[2]) > _e114.member_6) && ((_e826[1].member_1[2] - _e826[0].member[2]) > _e114.member_6)));
                                                if _e1094 {
                                                    phi_2475_ = bool();
                                                } else {
                                                    phi_2007_ = type_9(0u, 3u);
                                                    loop {
                                                        let _e1096 = phi_2007_;
                                                        let _e1099 = (_e1096.member < _e1096.member_1);
                                                        let _e1110 = select(type_9().member_1, _e1096.member, _e1099);
                                                        if (bitcast<i32>(select(0u, 1u, _e1099)) != 0i) {
                                                            let _e1114 = ((6u * _e776.x) + _e1110);
                                                            let _e1117 = keys.member[(2u * _e1114)];
                                                            let _e1121 = keys.member[((2u * _e1114) + 1u)];
                                                            let _e1124 = ((6u * _e776.y) + _e1110);
                                                            let _e1127 = keys.member[(2u * _e1124)];
                                                            let _e1131 = keys.member[((2u * _e1124) + 1u)];
                                                            let _e1133 = function_1(array<u32, 2>(_e1117, _e1121), array<u32, 2>(_e1127, _e1131));
                                                            let _e1135 = ((6u * _e776.z) + _e1110);
                                                            let _e1138 = keys.member[(2u * _e1135)];
                                                            let _e1142 = keys.member[((2u * _e1135) + 1u)];
                                                            let _e1144 = function_1(_e1133, array<u32, 2>(_e1138, _e1142));
                                                            let _e1147 = (((6u * _e782.x) + 3u) + _e1110);
                                                            let _e1150 = keys.member[(2u * _e1147)];
                                                            let _e1154 = keys.member[((2u * _e1147) + 1u)];
                                                            let _e1158 = (((6u * _e782.y) + 3u) + _e1110);
                                                            let _e1161 = keys.member[(2u * _e1158)];
                                                            let _e1165 = keys.member[((2u * _e1158) + 1u)];
                                                            let _e1167 = function_(array<u32, 2>(_e1150, _e1154), array<u32, 2>(_e1161, _e1165));
                                                            let _e1170 = (((6u * _e782.z) + 3u) + _e1110);
                                                            let _e1173 = keys.member[(2u * _e1170)];
                                                            let _e1177 = keys.member[((2u * _e1170) + 1u)];
                                                            let _e1179 = function_(_e1167, array<u32, 2>(_e1173, _e1177));
                                                            let _e1190 = select(select(false, (_e1144[0] > _e1179[0]), (_e1144[1] == _e1179[1])), true, (_e1144[1] > _e1179[1]));
                                                            if _e1190 {
                                                                phi_2454_ = false;
                                                                phi_2455_ = false;
                                                            } else {
                                                                let _e1192 = ((6u * _e782.x) + _e1110);
                                                                let _e1195 = keys.member[(2u * _e1192)];
                                                                let _e1199 = keys.member[((2u * _e1192) + 1u)];
                                                                let _e1202 = ((6u * _e782.y) + _e1110);
                                                                let _e1205 = keys.member[(2u * _e1202)];
                                                                let _e1209 = keys.member[((2u * _e1202) + 1u)];
                                                                let _e1211 = function_1(array<u32, 2>(_e1195, _e1199), array<u32, 2>(_e1205, _e1209));
                                                                let _e1213 = ((6u * _e782.z) + _e1110);
                                                                let _e1216 = keys.member[(2u * _e1213)];
                                                                let _e1220 = keys.member[((2u * _e1213) + 1u)];
                                                                let _e1222 = function_1(_e1211, array<u32, 2>(_e1216, _e1220));
                                                                let _e1225 = (((6u * _e776.x) + 3u) + _e1110);
                                                                let _e1228 = keys.member[(2u * _e1225)];
                                                                let _e1232 = keys.member[((2u * _e1225) + 1u)];
                                                                let _e1236 = (((6u * _e776.y) + 3u) + _e1110);
                                                                let _e1239 = keys.member[(2u * _e1236)];
                                                                let _e1243 = keys.member[((2u * _e1236) + 1u)];
                                                                let _e1245 = function_(array<u32, 2>(_e1228, _e1232), array<u32, 2>(_e1239, _e1243));
                                                                let _e1248 = (((6u * _e776.z) + 3u) + _e1110);
                                                                let _e1251 = keys.member[(2u * _e1248)];
                                                                let _e1255 = keys.member[((2u * _e1248) + 1u)];
                                                                let _e1257 = function_(_e1245, array<u32, 2>(_e1251, _e1255));
                                                                let _e1268 = select(select(false, (_e1222[0] > _e1257[0]), (_e1222[1] == _e1257[1])), true, (_e1222[1] > _e1257[1]));
                                                                phi_2454_ = select(true, false, _e1268);
                                                                phi_2455_ = _e1268;
                                                            }
                                                            let _e1271 = phi_2454_;
                                                            let _e1273 = phi_2455_;
                                                            phi_2456_ = _e1271;
                                                            phi_2457_ = _e1190;
                                                            phi_2458_ = _e1273;
                                                        } else {
                                                            phi_2456_ = false;
                                                            phi_2457_ = false;
                                                            phi_2458_ = false;
                                                        }
                                                        let _e1275 = phi_2456_;
                                                        let _e1277 = phi_2457_;
                                                        let _e1279 = phi_2458_;
                                                        local_4 = _e1277;
                                                        local_5 = _e1279;
                                                        local_6 = _e1277;
                                                        continue;
                                                        continuing {
                                                            phi_2007_ = type_9(select(_e1096.member, (_e1096.member + 1u), _e1099), select(_e1096.member_1, _e1096.member_1, _e1099));
                                                            break if !(_e1275);
                                                        }
                                                    }
                                                    let _e1282 = local_4;
                                                    let _e1284 = local_5;
                                                    let _e1287 = local_6;
                                                    phi_2475_ = select(false, true, select(true, false, select(_e1287, true, select(_e1284, false, _e1282))));
                                                }
                                                let _e1292 = phi_2475_;
                                                phi_2476_ = _e1292;
                                                phi_2477_ = _e1094;
                                            } else {
                                                phi_2476_ = bool();
                                                phi_2477_ = true;
                                            }
                                            let _e1294 = phi_2476_;
                                            let _e1296 = phi_2477_;
                                            phi_2482_ = _e1294;
                                            phi_2483_ = select(true, false, _e1296);
                                        } else {
                                            phi_2482_ = false;
                                            phi_2483_ = true;
                                        }
                                        let _e1299 = phi_2482_;
                                        let _e1301 = phi_2483_;
                                        phi_2484_ = _e1299;
                                        phi_2485_ = _e1301;
                                    }
                                    let _e1303 = phi_2484_;
                                    let _e1305 = phi_2485_;
                                    let _e1306 = select(true, _e1303, _e1305);
                                    if _e1306 {
                                    } else {
                                        let _e1308 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_2506_ = select(_e568, select(_e568, (_e568 | (1u << bitcast<u32>((_e582 & 31u)))), _e715), _e1306);
                                } else {
                                    phi_2506_ = _e568;
                                }
                                let _e1316 = phi_2506_;
                                phi_2507_ = _e1316;
                                phi_2508_ = true;
                            }
                            let _e1318 = phi_2507_;
                            let _e1320 = phi_2508_;
                            phi_1136_ = _e1318;
                            phi_2509_ = _e1320;
                        } else {
                            phi_1136_ = u32();
                            phi_2509_ = false;
                        }
                        let _e1322 = phi_1136_;
                        let _e1324 = phi_2509_;
                        continue;
                        continuing {
                            phi_1132_ = type_9(select(_e566.member, (_e566.member + 1u), _e571), select(_e566.member_1, _e566.member_1, _e571));
                            phi_1135_ = _e1322;
                            break if !(_e1324);
                        }
                    }
                    let _e1328 = params.member.member_1.member_3;
                    let _e1330 = local_7;
                    let _e1333 = atomicAdd((&counters[5u]), countOneBits(_e1330));
                    workgroupBarrier();
                    if (_e58 == 0u) {
                        let _e1336 = atomicLoad((&counters[5u]));
                        if (_e1336 > 0u) {
                            let _e1340 = params.member.member.member_1;
                            if ((_e1340 & 1024u) != 0u) {
                                let _e1350 = atomicAdd((&output.member[0u]), _e1336);
                                let _e1351 = (_e1350 + _e1336);
                                let _e1353 = select(_e1351, 4294967295u, (_e1351 < _e1350));
                                let _e1356 = params.member.member_1.member_3;
                                if (_e1353 > _e1356) {
                                    let _e1359 = atomicMax((&output.member[2u]), _e1353);
                                }
                                phi_2568_ = _e1350;
                            } else {
                                let _e1344 = atomicAdd((&output.member[0u]), _e1336);
                                if ((_e1344 + _e1336) < _e1344) {
                                    let _e1348 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2568_ = _e1344;
                            }
                            let _e1361 = phi_2568_;
                            atomicStore((&counters[6u]), _e1361);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1365 = atomicLoad((&counters[6u]));
                    let _e1367 = (_e564 / 128u);
                    phi_2592_ = type_9(0u, select(_e1367, (_e1367 + 1u), ((_e564 % 128u) > 0u)));
                    phi_2595_ = (_e1333 + _e1365);
                    loop {
                        let _e1374 = phi_2592_;
                        let _e1376 = phi_2595_;
                        let _e1379 = (_e1374.member < _e1374.member_1);
                        let _e1390 = select(type_9().member_1, _e1374.member, _e1379);
                        let _e1392 = (bitcast<i32>(select(0u, 1u, _e1379)) != 0i);
                        if _e1392 {
                            let _e1395 = local_8;
                            if (((_e1395 >> bitcast<u32>((_e1390 & 31u))) & 1u) == 1u) {
                                let _e1403 = hits[(_e58 + (_e1390 * 128u))];
                                let _e1406 = ((_e1403 >> bitcast<u32>(10i)) & 3u);
                                let _e1414 = names[((_e1406 * 32u) + (_e1403 & 31u))];
                                let _e1417 = firsts[(2u * _e1406)];
                                let _e1422 = firsts[((2u * _e1406) + 1u)];
                                let _e1425 = leaves.member[(_e1417 + ((_e1403 >> bitcast<u32>(5i)) & 31u))];
                                let _e1428 = leaves.member[(_e1422 + _e1414)];
                                if (_e117 == 1u) {
                                    let _e1432 = (_e1425.w < _e1428.w);
                                    phi_2693_ = type_9(select(_e1428.w, _e1425.w, _e1432), select(_e1425.w, _e1428.w, _e1432));
                                } else {
                                    phi_2693_ = type_9(_e1425.w, _e1428.w);
                                }
                                let _e1437 = phi_2693_;
                                if (_e1376 < _e1328) {
                                    let _e1441 = (2u * _e1376);
                                    atomicStore((&output.member[(4u + _e1441)]), _e1437.member);
                                    atomicStore((&output.member[(_e1441 + 5u)]), _e1437.member_1);
                                }
                                phi_2708_ = (_e1376 + 1u);
                            } else {
                                phi_2708_ = _e1376;
                            }
                            let _e1448 = phi_2708_;
                            phi_2596_ = _e1448;
                        } else {
                            phi_2596_ = u32();
                        }
                        let _e1450 = phi_2596_;
                        continue;
                        continuing {
                            phi_2592_ = type_9(select(_e1374.member, (_e1374.member + 1u), _e1379), select(_e1374.member_1, _e1374.member_1, _e1379));
                            phi_2595_ = _e1450;
                            break if !(_e1392);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_950_ = type_9(select(_e462.member, (_e462.member + 1u), _e465), select(_e462.member_1, _e462.member_1, _e465));
                    break if !(_e478);
                }
            }
            phi_285_ = (_e131 + (_e57.x * _e57.y));
        } else {
            phi_285_ = u32();
        }
        let _e1454 = phi_285_;
        continue;
        continuing {
            phi_284_ = _e1454;
            break if !(_e137);
        }
    }
    if (_e58 == 0u) {
        let _e1458 = atomicLoad((&counters[7u]));
        if (_e1458 > 0u) {
            let _e1461 = atomicAdd((&output.member[1u]), _e1458);
            if ((_e1461 + _e1458) < _e1461) {
                let _e1465 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_wanted(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
