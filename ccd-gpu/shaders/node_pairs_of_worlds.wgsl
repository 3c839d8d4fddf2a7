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
var<workgroup> rows: array<u32, 4>;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 384>;
@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> output: type_31;
var<workgroup> ranges: array<u32, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_165_: u32;
    var phi_192_: u32;
    var phi_283_: u32;
    var phi_399_: type_9;
    var phi_402_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_495_: type_9;
    var phi_498_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_678_: bool;
    var phi_714_: type_9;
    var phi_717_: u32;
    var phi_718_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_936_: type_9;
    var phi_939_: u32;
    var phi_940_: u32;
    var phi_1004_: u32;
    var phi_1005_: u32;
    var phi_1009_: type_9;
    var phi_1012_: u32;
    var phi_1013_: u32;
    var local_11: u32;
    var phi_1099_: type_9;
    var local_12: u32;
    var phi_1149_: type_9;
    var phi_1152_: u32;
    var phi_1154_: u32;
    var phi_1156_: u32;
    var phi_1153_: u32;
    var phi_1155_: u32;
    var phi_1157_: u32;
    var phi_1319_: u32;
    var phi_1326_: type_9;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_284_: u32;
    var local_13: u32;
    var local_14: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e62 = params.member.member_1.member_2;
    let _e64 = input.member[0u];
    let _e66 = select(_e64, _e62, (_e62 < _e64));
    let _e69 = params.member.member_1.member_1;
    if (_e66 > _e69) {
        let _e73 = params.member.member_1.member_1;
        phi_165_ = (_e66 - _e73);
    } else {
        phi_165_ = 0u;
    }
    let _e76 = phi_165_;
    let _e79 = params.member.member_2.member_3;
    if (_e79 == 1u) {
        phi_192_ = _e76;
    } else {
        let _e83 = params.member.member_2.member_3;
        if (_e83 == 0u) {
            return;
        }
        let _e85 = (_e76 / _e83);
        if (_e83 == 0u) {
            return;
        }
        phi_192_ = select(_e85, (_e85 + 1u), ((_e76 % _e83) > 0u));
    }
    let _e92 = phi_192_;
    let _e95 = params.member.member_2.member_4;
    let _e97 = select(_e92, _e95, (_e95 < _e92));
    let _e101 = params.member.member_2.member_2;
    let _e103 = params.member.member_2.member_1;
    let _e104 = (_e103 == 0u);
    let _e105 = select(1u, 0u, _e104);
    let _e110 = params.member.member_2.member[_e101][_e105];
    let _e115 = params.member.member_2.member[(_e101 - 1u)][_e105];
    let _e120 = params.member.member_2.member[(_e101 - 1u)][select(1u, 2u, _e104)];
    let _e122 = (_e46 % 32u);
    phi_283_ = ((_e44.y * _e45.x) + _e44.x);
    loop {
        let _e124 = phi_283_;
        let _e125 = (_e97 / 4u);
        let _e130 = (_e124 < select(_e125, (_e125 + 1u), ((_e97 % 4u) > 0u)));
        if _e130 {
            let _e133 = ((_e124 * 4u) + (_e46 / 32u));
            let _e134 = (_e133 < _e97);
            let _e137 = params.member.member_1.member_1;
            let _e140 = params.member.member_2.member_3;
            let _e144 = (2u * (_e137 + select(0u, (_e133 * _e140), _e134)));
            let _e147 = input.member[(4u + _e144)];
            let _e150 = input.member[(_e144 + 5u)];
            if (_e46 <= 5u) {
                atomicStore((&counters[_e46]), 0u);
            }
            workgroupBarrier();
            let _e156 = params.member.member_2.member_1;
            let _e157 = (_e156 == 0u);
            let _e158 = select(1u, 0u, _e157);
            let _e159 = select(1u, 2u, _e157);
            let _e162 = params.member.member_2.member_2;
            let _e163 = (_e162 - 1u);
            let _e166 = params.member.member.member;
            local = array<u32, 3>(_e166[0], _e166[1], _e166[2]);
            let _e172 = ((_e147 * 32u) + _e122);
            let _e174 = local[_e158];
            phi_399_ = type_9(0u, _e163);
            phi_402_ = 1u;
            loop {
                let _e177 = phi_399_;
                let _e179 = phi_402_;
                local_1 = _e179;
                local_2 = _e179;
                local_3 = _e179;
                local_4 = _e179;
                let _e182 = (_e177.member < _e177.member_1);
                let _e193 = (bitcast<i32>(select(0u, 1u, _e182)) != 0i);
                continue;
                continuing {
                    phi_399_ = type_9(select(_e177.member, (_e177.member + 1u), _e182), select(_e177.member_1, _e177.member_1, _e182));
                    phi_402_ = select(u32(), (_e179 * 32u), _e193);
                    break if !(_e193);
                }
            }
            let _e199 = local_1;
            if (_e199 == 0u) {
                return;
            }
            let _e202 = local_2;
            let _e203 = ((_e174 - 1u) / _e202);
            let _e207 = local_3;
            let _e208 = (select(_e172, _e203, (_e203 < _e172)) * _e207);
            let _e210 = local_4;
            let _e212 = (_e208 + (_e210 - 1u));
            let _e213 = (_e174 - 1u);
            let _e219 = params.member.member_2.member[0u][_e158];
            let _e222 = worlds.member[(_e219 + _e208)];
            let _e227 = worlds.member[(_e219 + select(_e212, _e213, (_e213 < _e212)))];
            let _e228 = ((_e222 << bitcast<u32>(16i)) | _e227);
            let _e230 = ((_e150 * 32u) + _e122);
            let _e232 = local[_e159];
            phi_495_ = type_9(0u, _e163);
            phi_498_ = 1u;
            loop {
                let _e235 = phi_495_;
                let _e237 = phi_498_;
                local_5 = _e237;
                local_6 = _e237;
                local_7 = _e237;
                local_8 = _e237;
                let _e240 = (_e235.member < _e235.member_1);
                let _e251 = (bitcast<i32>(select(0u, 1u, _e240)) != 0i);
                continue;
                continuing {
                    phi_495_ = type_9(select(_e235.member, (_e235.member + 1u), _e240), select(_e235.member_1, _e235.member_1, _e240));
                    phi_498_ = select(u32(), (_e237 * 32u), _e251);
                    break if !(_e251);
                }
            }
            let _e257 = local_5;
            if (_e257 == 0u) {
                return;
            }
            let _e260 = local_6;
            let _e261 = ((_e232 - 1u) / _e260);
            let _e265 = local_7;
            let _e266 = (select(_e230, _e261, (_e261 < _e230)) * _e265);
            let _e268 = local_8;
            let _e270 = (_e266 + (_e268 - 1u));
            let _e271 = (_e232 - 1u);
            let _e277 = params.member.member_2.member[0u][_e159];
            let _e280 = worlds.member[(_e277 + _e266)];
            let _e285 = worlds.member[(_e277 + select(_e270, _e271, (_e271 < _e270)))];
            ranges[_e46] = ((_e280 << bitcast<u32>(16i)) | _e285);
            let _e290 = params.member.member_2.member_1;
            let _e293 = select(false, (_e147 == _e150), (_e290 == 1u));
            let _e294 = (_e46 / 32u);
            let _e295 = (_e46 % 32u);
            let _e298 = ((_e115 + (_e147 * 32u)) + _e295);
            let _e301 = ((_e120 + (_e150 * 32u)) + _e295);
            let _e304 = nodes.member[(_e110 + _e147)];
            let _e318 = nodes.member[_e298];
            let _e332 = nodes.member[_e301];
            if (_e295 == 0u) {
                rows[_e294] = _e298;
            }
            if _e134 {
                if _e293 {
                    phi_678_ = true;
                } else {
                    phi_678_ = ((((((_e332.member.x <= _e304.member_1.y) && (_e304.member.x <= _e332.member_1.y)) && (_e332.member.y <= _e304.member_2.x)) && (_e304.member.y <= _e332.member_2.x)) && (_e332.member_1.x <= _e304.member_2.y)) && (_e304.member_1.x <= _e332.member_2.y));
                }
                let _e359 = phi_678_;
                if _e359 {
                    let _e361 = atomicAdd((&counters[_e294]), 1u);
                    let _e364 = ((_e294 * 32u) + select(_e361, _e295, _e293));
                    columns[_e364] = type_24(array<f32, 3>(_e332.member.x, _e332.member.y, _e332.member_1.x), array<f32, 3>(_e332.member_1.y, _e332.member_2.x, _e332.member_2.y));
                    names[_e364] = _e301;
                }
            }
            workgroupBarrier();
            let _e370 = (_e46 / 32u);
            let _e372 = (_e370 * 32u);
            let _e374 = atomicLoad((&counters[_e370]));
            phi_714_ = type_9(0u, ((_e374 + 3u) / 4u));
            phi_717_ = 0u;
            loop {
                let _e379 = phi_714_;
                let _e381 = phi_717_;
                local_9 = _e381;
                local_10 = _e381;
                let _e384 = (_e379.member < _e379.member_1);
                let _e397 = (bitcast<i32>(select(0u, 1u, _e384)) != 0i);
                if _e397 {
                    let _e398 = (4u * select(type_9().member_1, _e379.member, _e384));
                    let _e401 = columns[(_e372 + _e398)];
                    let _e425 = columns[((_e372 + _e398) + 1u)];
                    let _e452 = columns[((_e372 + _e398) + 2u)];
                    let _e479 = columns[((_e372 + _e398) + 3u)];
                    phi_718_ = (_e381 | ((((select(0u, 1u, ((((((_e318.member.x <= _e401.member_1[0]) && (_e401.member[0] <= _e318.member_1.y)) && (_e318.member.y <= _e401.member_1[1])) && (_e401.member[1] <= _e318.member_2.x)) && (_e318.member_1.x <= _e401.member_1[2])) && (_e401.member[2] <= _e318.member_2.y))) | (select(0u, 1u, ((((((_e318.member.x <= _e425.member_1[0]) && (_e425.member[0] <= _e318.member_1.y)) && (_e318.member.y <= _e425.member_1[1])) && (_e425.member[1] <= _e318.member_2.x)) && (_e318.member_1.x <= _e425.member_1[2])) && (_e425.member[2] <= _e318.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e318.member.x <= _e452.member_1[0]) && (_e452.member[0] <= _e318.member_1.y)) && (_e318.member.y <= _e452.member_1[1])) && (_e452.member[1] <= _e318.member_2.x)) && (_e318.member_1.x <= _e452.member_1[2])) && (_e452.member[2] <= _e318.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e318.member.x <= _e479.member_1[0]) && (_e479.member[0] <= _e318.member_1.y)) && (_e318.member.y <= _e479.member_1[1])) && (_e479.member[1] <= _e318.member_2.x)) && (_e318.member_1.x <= _e479.member_1[2])) && (_e479.member[2] <= _e318.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e398 & 31u))));
                } else {
                    phi_718_ = u32();
                }
                let _e508 = phi_718_;
                continue;
                continuing {
                    phi_714_ = type_9(select(_e379.member, (_e379.member + 1u), _e384), select(_e379.member_1, _e379.member_1, _e384));
                    phi_717_ = _e508;
                    break if !(_e397);
                }
            }
            let _e516 = local_9;
            let _e519 = local_10;
            let _e520 = select(_e519, (_e516 & ((1u << bitcast<u32>((_e374 & 31u))) - 1u)), (_e374 < 32u));
            let _e525 = select(_e520, (_e520 & (4294967295u << bitcast<u32>(((_e46 % 32u) & 31u)))), _e293);
            let _e528 = params.member.member.member_1;
            if ((_e528 & 256u) != 0u) {
                if select(!((_e318.member.x <= _e318.member_1.y)), true, ((bitcast<u32>(_e318.member_1.y) & 1u) == 1u)) {
                    phi_936_ = type_9(0u, _e374);
                    phi_939_ = _e525;
                    loop {
                        let _e539 = phi_936_;
                        let _e541 = phi_939_;
                        local_13 = _e541;
                        let _e544 = (_e539.member < _e539.member_1);
                        let _e555 = select(type_9().member_1, _e539.member, _e544);
                        let _e557 = (bitcast<i32>(select(0u, 1u, _e544)) != 0i);
                        if _e557 {
                            let _e560 = columns[(_e372 + _e555)];
                            phi_940_ = select(_e541, (_e541 & ~((1u << bitcast<u32>((_e555 & 31u))))), select(!((_e560.member[0] <= _e560.member_1[0])), true, ((bitcast<u32>(_e560.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_940_ = u32();
                        }
                        let _e578 = phi_940_;
                        continue;
                        continuing {
                            phi_936_ = type_9(select(_e539.member, (_e539.member + 1u), _e544), select(_e539.member_1, _e539.member_1, _e544));
                            phi_939_ = _e578;
                            break if !(_e557);
                        }
                    }
                    let _e860 = local_13;
                    phi_1004_ = _e860;
                } else {
                    phi_1004_ = _e525;
                }
                let _e581 = phi_1004_;
                phi_1005_ = _e581;
            } else {
                phi_1005_ = _e525;
            }
            let _e583 = phi_1005_;
            phi_1009_ = type_9(0u, _e374);
            phi_1012_ = _e583;
            loop {
                let _e586 = phi_1009_;
                let _e588 = phi_1012_;
                local_11 = _e588;
                local_12 = _e588;
                local_14 = _e588;
                let _e591 = (_e586.member < _e586.member_1);
                let _e602 = select(type_9().member_1, _e586.member, _e591);
                let _e604 = (bitcast<i32>(select(0u, 1u, _e591)) != 0i);
                if _e604 {
                    let _e607 = names[(_e372 + _e602)];
                    let _e611 = ranges[(_e372 + (_e607 % 32u))];
                    phi_1013_ = select((_e588 & ~((1u << bitcast<u32>((_e602 & 31u))))), _e588, select(false, ((_e611 >> bitcast<u32>(16i)) <= (_e228 & 65535u)), ((_e228 >> bitcast<u32>(16i)) <= (_e611 & 65535u))));
                } else {
                    phi_1013_ = u32();
                }
                let _e628 = phi_1013_;
                continue;
                continuing {
                    phi_1009_ = type_9(select(_e586.member, (_e586.member + 1u), _e591), select(_e586.member_1, _e586.member_1, _e591));
                    phi_1012_ = _e628;
                    break if !(_e604);
                }
            }
            let _e631 = local_11;
            let _e634 = atomicAdd((&counters[4u]), countOneBits(_e631));
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e637 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e637;
            }
            let _e640 = workgroupUniformLoad((&n_hits[0u]));
            let _e641 = (_e640 / 384u);
            phi_1099_ = type_9(0u, select(_e641, (_e641 + 1u), ((_e640 % 384u) > 0u)));
            loop {
                let _e648 = phi_1099_;
                let _e651 = (_e648.member < _e648.member_1);
                let _e664 = (bitcast<i32>(select(0u, 1u, _e651)) != 0i);
                if _e664 {
                    let _e665 = (_e46 / 32u);
                    let _e666 = (select(type_9().member_1, _e648.member, _e651) * 384u);
                    let _e672 = local_12;
                    if (_e672 == 0u) {
                    } else {
                        let _e675 = atomicLoad((&counters[_e665]));
                        phi_1149_ = type_9(0u, ((_e675 + 3u) / 4u));
                        phi_1152_ = (_e634 - _e666);
                        phi_1154_ = ((_e46 * 128u) + (_e665 * 32u));
                        let _e873 = local_14;
                        phi_1156_ = _e873;
                        loop {
                            let _e680 = phi_1149_;
                            let _e682 = phi_1152_;
                            let _e684 = phi_1154_;
                            let _e686 = phi_1156_;
                            let _e689 = (_e680.member < _e680.member_1);
                            let _e700 = (bitcast<i32>(select(0u, 1u, _e689)) != 0i);
                            if _e700 {
                                let _e701 = (_e686 & 1u);
                                if (_e701 == 0u) {
                                } else {
                                    if (_e682 < 384u) {
                                        hits[_e682] = _e684;
                                    }
                                }
                                let _e707 = select((_e682 + 1u), _e682, (_e701 == 0u));
                                let _e708 = (_e686 & 2u);
                                if (_e708 == 0u) {
                                } else {
                                    if (_e707 < 384u) {
                                        hits[_e707] = (_e684 + 1u);
                                    }
                                }
                                let _e715 = select((_e707 + 1u), _e707, (_e708 == 0u));
                                let _e716 = (_e686 & 4u);
                                if (_e716 == 0u) {
                                } else {
                                    if (_e715 < 384u) {
                                        hits[_e715] = (_e684 + 2u);
                                    }
                                }
                                let _e723 = select((_e715 + 1u), _e715, (_e716 == 0u));
                                let _e724 = (_e686 & 8u);
                                if (_e724 == 0u) {
                                } else {
                                    if (_e723 < 384u) {
                                        hits[_e723] = (_e684 + 3u);
                                    }
                                }
                                phi_1153_ = select((_e723 + 1u), _e723, (_e724 == 0u));
                                phi_1155_ = (_e684 + 4u);
                                phi_1157_ = (_e686 >> bitcast<u32>(4i));
                            } else {
                                phi_1153_ = u32();
                                phi_1155_ = u32();
                                phi_1157_ = u32();
                            }
                            let _e736 = phi_1153_;
                            let _e738 = phi_1155_;
                            let _e740 = phi_1157_;
                            continue;
                            continuing {
                                phi_1149_ = type_9(select(_e680.member, (_e680.member + 1u), _e689), select(_e680.member_1, _e680.member_1, _e689));
                                phi_1152_ = _e736;
                                phi_1154_ = _e738;
                                phi_1156_ = _e740;
                                break if !(_e700);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e743 = n_hits[0u];
                    let _e744 = (_e743 - _e666);
                    let _e746 = select(_e744, 384u, (384u < _e744));
                    if (_e46 == 0u) {
                        atomicStore((&counters[5u]), _e746);
                    }
                    workgroupBarrier();
                    if (_e46 == 0u) {
                        let _e751 = atomicLoad((&counters[5u]));
                        if (_e751 > 0u) {
                            let _e755 = params.member.member.member_1;
                            if ((_e755 & 1024u) != 0u) {
                                let _e765 = atomicAdd((&output.member[0u]), _e751);
                                let _e766 = (_e765 + _e751);
                                let _e768 = select(_e766, 4294967295u, (_e766 < _e765));
                                let _e771 = params.member.member_1.member_3;
                                if (_e768 > _e771) {
                                    let _e774 = atomicMax((&output.member[2u]), _e768);
                                }
                                phi_1319_ = _e765;
                            } else {
                                let _e759 = atomicAdd((&output.member[0u]), _e751);
                                if ((_e759 + _e751) < _e759) {
                                    let _e763 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1319_ = _e759;
                            }
                            let _e776 = phi_1319_;
                            atomicStore((&counters[6u]), _e776);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e780 = atomicLoad((&counters[6u]));
                    phi_1326_ = type_9(0u, 3u);
                    loop {
                        let _e782 = phi_1326_;
                        let _e785 = (_e782.member < _e782.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e785)) != 0i) {
                            let _e800 = (_e46 + (select(type_9().member_1, _e782.member, _e785) * 128u));
                            if (_e800 >= _e746) {
                                phi_1392_ = false;
                            } else {
                                let _e803 = hits[_e800];
                                let _e806 = rows[(_e803 / 4096u)];
                                let _e812 = names[(_e803 % 128u)];
                                let _e817 = params.member.member_1.member_3;
                                let _e818 = (_e780 + _e800);
                                if (_e818 < _e817) {
                                    let _e820 = (2u * _e818);
                                    atomicStore((&output.member[(4u + _e820)]), ((_e806 + ((_e803 / 128u) % 32u)) - _e115));
                                    atomicStore((&output.member[(_e820 + 5u)]), (_e812 - _e120));
                                }
                                phi_1392_ = true;
                            }
                            let _e826 = phi_1392_;
                            phi_1393_ = _e826;
                        } else {
                            phi_1393_ = false;
                        }
                        let _e828 = phi_1393_;
                        continue;
                        continuing {
                            phi_1326_ = type_9(select(_e782.member, (_e782.member + 1u), _e785), select(_e782.member_1, _e782.member_1, _e785));
                            break if !(_e828);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1099_ = type_9(select(_e648.member, (_e648.member + 1u), _e651), select(_e648.member_1, _e648.member_1, _e651));
                    break if !(_e664);
                }
            }
            phi_284_ = (_e124 + (_e45.x * _e45.y));
        } else {
            phi_284_ = u32();
        }
        let _e832 = phi_284_;
        continue;
        continuing {
            phi_283_ = _e832;
            break if !(_e130);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
