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

struct type_32 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> output: type_32;
var<workgroup> ranges: array<u32, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_163_: u32;
    var phi_190_: u32;
    var phi_222_: u32;
    var phi_349_: type_9;
    var phi_352_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_445_: type_9;
    var phi_448_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_681_: bool;
    var phi_731_: type_9;
    var phi_734_: u32;
    var phi_735_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_953_: type_9;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_1021_: u32;
    var phi_1022_: u32;
    var phi_1026_: type_9;
    var phi_1029_: u32;
    var phi_1030_: u32;
    var local_11: u32;
    var phi_1115_: type_9;
    var local_12: u32;
    var phi_1181_: type_9;
    var phi_1184_: u32;
    var phi_1186_: u32;
    var phi_1188_: u32;
    var phi_1185_: u32;
    var phi_1187_: u32;
    var phi_1189_: u32;
    var phi_1351_: u32;
    var phi_1358_: type_9;
    var phi_1431_: bool;
    var phi_1432_: bool;
    var phi_223_: u32;
    var local_13: u32;
    var local_14: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e45 = id_2;
    let _e46 = n_2;
    let _e47 = lane_2;
    let _e63 = params.member.member_1.member_2;
    let _e65 = input.member[0u];
    let _e67 = select(_e65, _e63, (_e63 < _e65));
    let _e70 = params.member.member_1.member_1;
    if (_e67 > _e70) {
        let _e74 = params.member.member_1.member_1;
        phi_163_ = (_e67 - _e74);
    } else {
        phi_163_ = 0u;
    }
    let _e77 = phi_163_;
    let _e80 = params.member.member_2.member_3;
    if (_e80 == 1u) {
        phi_190_ = _e77;
    } else {
        let _e84 = params.member.member_2.member_3;
        if (_e84 == 0u) {
            return;
        }
        let _e86 = (_e77 / _e84);
        if (_e84 == 0u) {
            return;
        }
        phi_190_ = select(_e86, (_e86 + 1u), ((_e77 % _e84) > 0u));
    }
    let _e93 = phi_190_;
    let _e96 = params.member.member_2.member_4;
    let _e98 = select(_e93, _e96, (_e96 < _e93));
    let _e100 = (_e47 / 32u);
    let _e101 = (_e47 % 32u);
    phi_222_ = ((_e45.y * _e46.x) + _e45.x);
    loop {
        let _e103 = phi_222_;
        let _e104 = (_e98 / 4u);
        let _e109 = (_e103 < select(_e104, (_e104 + 1u), ((_e98 % 4u) > 0u)));
        if _e109 {
            let _e112 = ((_e103 * 4u) + (_e47 / 32u));
            let _e113 = (_e112 < _e98);
            let _e116 = params.member.member_1.member_1;
            let _e119 = params.member.member_2.member_3;
            let _e123 = (2u * (_e116 + select(0u, (_e112 * _e119), _e113)));
            let _e126 = input.member[(4u + _e123)];
            let _e129 = input.member[(_e123 + 5u)];
            if (_e47 <= 5u) {
                atomicStore((&counters[_e47]), 0u);
            }
            workgroupBarrier();
            if (_e101 == 0u) {
                firsts[(2u * _e100)] = (_e126 * 32u);
                firsts[((2u * _e100) + 1u)] = (_e129 * 32u);
            }
            let _e143 = params.member.member_2.member_1;
            let _e144 = (_e143 == 0u);
            let _e145 = select(1u, 0u, _e144);
            let _e146 = select(1u, 2u, _e144);
            let _e149 = params.member.member_2.member_2;
            let _e150 = (_e149 - 1u);
            let _e153 = params.member.member.member;
            local = array<u32, 3>(_e153[0], _e153[1], _e153[2]);
            let _e159 = ((_e126 * 32u) + _e101);
            let _e161 = local[_e145];
            phi_349_ = type_9(0u, _e150);
            phi_352_ = 1u;
            loop {
                let _e164 = phi_349_;
                let _e166 = phi_352_;
                local_1 = _e166;
                local_2 = _e166;
                local_3 = _e166;
                local_4 = _e166;
                let _e169 = (_e164.member < _e164.member_1);
                let _e180 = (bitcast<i32>(select(0u, 1u, _e169)) != 0i);
                continue;
                continuing {
                    phi_349_ = type_9(select(_e164.member, (_e164.member + 1u), _e169), select(_e164.member_1, _e164.member_1, _e169));
                    phi_352_ = select(u32(), (_e166 * 32u), _e180);
                    break if !(_e180);
                }
            }
            let _e186 = local_1;
            if (_e186 == 0u) {
                return;
            }
            let _e189 = local_2;
            let _e190 = ((_e161 - 1u) / _e189);
            let _e194 = local_3;
            let _e195 = (select(_e159, _e190, (_e190 < _e159)) * _e194);
            let _e197 = local_4;
            let _e199 = (_e195 + (_e197 - 1u));
            let _e200 = (_e161 - 1u);
            let _e206 = params.member.member_2.member[0u][_e145];
            let _e209 = worlds.member[(_e206 + _e195)];
            let _e214 = worlds.member[(_e206 + select(_e199, _e200, (_e200 < _e199)))];
            let _e215 = ((_e209 << bitcast<u32>(16i)) | _e214);
            let _e217 = ((_e129 * 32u) + _e101);
            let _e219 = local[_e146];
            phi_445_ = type_9(0u, _e150);
            phi_448_ = 1u;
            loop {
                let _e222 = phi_445_;
                let _e224 = phi_448_;
                local_5 = _e224;
                local_6 = _e224;
                local_7 = _e224;
                local_8 = _e224;
                let _e227 = (_e222.member < _e222.member_1);
                let _e238 = (bitcast<i32>(select(0u, 1u, _e227)) != 0i);
                continue;
                continuing {
                    phi_445_ = type_9(select(_e222.member, (_e222.member + 1u), _e227), select(_e222.member_1, _e222.member_1, _e227));
                    phi_448_ = select(u32(), (_e224 * 32u), _e238);
                    break if !(_e238);
                }
            }
            let _e244 = local_5;
            if (_e244 == 0u) {
                return;
            }
            let _e247 = local_6;
            let _e248 = ((_e219 - 1u) / _e247);
            let _e252 = local_7;
            let _e253 = (select(_e217, _e248, (_e248 < _e217)) * _e252);
            let _e255 = local_8;
            let _e257 = (_e253 + (_e255 - 1u));
            let _e258 = (_e219 - 1u);
            let _e264 = params.member.member_2.member[0u][_e146];
            let _e267 = worlds.member[(_e264 + _e253)];
            let _e272 = worlds.member[(_e264 + select(_e257, _e258, (_e258 < _e257)))];
            ranges[_e47] = ((_e267 << bitcast<u32>(16i)) | _e272);
            let _e277 = params.member.member_2.member_1;
            let _e280 = select(false, (_e126 == _e129), (_e277 == 1u));
            let _e283 = params.member.member_2.member_2;
            let _e286 = params.member.member_2.member_1;
            let _e287 = (_e286 == 0u);
            let _e288 = select(1u, 0u, _e287);
            let _e290 = (_e47 / 32u);
            let _e291 = (_e47 % 32u);
            let _e295 = params.member.member_2.member[_e283][_e288];
            let _e298 = nodes.member[(_e295 + _e126)];
            let _e317 = params.member.member_2.member[(_e283 - 1u)][_e288];
            let _e320 = nodes.member[(_e317 + ((_e126 * 32u) + _e291))];
            let _e339 = params.member.member_2.member[(_e283 - 1u)][select(1u, 2u, _e287)];
            let _e342 = nodes.member[(_e339 + ((_e129 * 32u) + _e291))];
            if _e113 {
                if _e280 {
                    phi_681_ = true;
                } else {
                    phi_681_ = ((((((_e342.member.x <= _e298.member_1.y) && (_e298.member.x <= _e342.member_1.y)) && (_e342.member.y <= _e298.member_2.x)) && (_e298.member.y <= _e342.member_2.x)) && (_e342.member_1.x <= _e298.member_2.y)) && (_e298.member_1.x <= _e342.member_2.y));
                }
                let _e367 = phi_681_;
                if _e367 {
                    let _e369 = atomicAdd((&counters[_e290]), 1u);
                    let _e372 = ((_e290 * 32u) + select(_e369, _e291, _e280));
                    columns[_e372] = type_24(array<f32, 3>(_e342.member.x, _e342.member.y, _e342.member_1.x), array<f32, 3>(_e342.member_1.y, _e342.member_2.x, _e342.member_2.y));
                    names[_e372] = _e291;
                }
            }
            workgroupBarrier();
            let _e378 = (_e47 / 32u);
            let _e380 = (_e378 * 32u);
            let _e382 = atomicLoad((&counters[_e378]));
            let _e383 = (_e382 / 4u);
            phi_731_ = type_9(0u, select(_e383, (_e383 + 1u), ((_e382 % 4u) > 0u)));
            phi_734_ = 0u;
            loop {
                let _e390 = phi_731_;
                let _e392 = phi_734_;
                local_9 = _e392;
                local_10 = _e392;
                let _e395 = (_e390.member < _e390.member_1);
                let _e408 = (bitcast<i32>(select(0u, 1u, _e395)) != 0i);
                if _e408 {
                    let _e409 = (4u * select(type_9().member_1, _e390.member, _e395));
                    let _e412 = columns[(_e380 + _e409)];
                    let _e436 = columns[((_e380 + _e409) + 1u)];
                    let _e463 = columns[((_e380 + _e409) + 2u)];
                    let _e490 = columns[((_e380 + _e409) + 3u)];
                    phi_735_ = (_e392 | ((((select(0u, 1u, ((((((_e320.member.x <= _e412.member_1[0]) && (_e412.member[0] <= _e320.member_1.y)) && (_e320.member.y <= _e412.member_1[1])) && (_e412.member[1] <= _e320.member_2.x)) && (_e320.member_1.x <= _e412.member_1[2])) && (_e412.member[2] <= _e320.member_2.y))) | (select(0u, 1u, ((((((_e320.member.x <= _e436.member_1[0]) && (_e436.member[0] <= _e320.member_1.y)) && (_e320.member.y <= _e436.member_1[1])) && (_e436.member[1] <= _e320.member_2.x)) && (_e320.member_1.x <= _e436.member_1[2])) && (_e436.member[2] <= _e320.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e320.member.x <= _e463.member_1[0]) && (_e463.member[0] <= _e320.member_1.y)) && (_e320.member.y <= _e463.member_1[1])) && (_e463.member[1] <= _e320.member_2.x)) && (_e320.member_1.x <= _e463.member_1[2])) && (_e463.member[2] <= _e320.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e320.member.x <= _e490.member_1[0]) && (_e490.member[0] <= _e320.member_1.y)) && (_e320.member.y <= _e490.member_1[1])) && (_e490.member[1] <= _e320.member_2.x)) && (_e320.member_1.x <= _e490.member_1[2])) && (_e490.member[2] <= _e320.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e409 & 31u))));
                } else {
                    phi_735_ = u32();
                }
                let _e519 = phi_735_;
                continue;
                continuing {
                    phi_731_ = type_9(select(_e390.member, (_e390.member + 1u), _e395), select(_e390.member_1, _e390.member_1, _e395));
                    phi_734_ = _e519;
                    break if !(_e408);
                }
            }
            let _e527 = local_9;
            let _e530 = local_10;
            let _e531 = select(_e530, (_e527 & ((1u << bitcast<u32>((_e382 & 31u))) - 1u)), (_e382 < 32u));
            let _e536 = select(_e531, (_e531 & (4294967295u << bitcast<u32>(((_e47 % 32u) & 31u)))), _e280);
            let _e539 = params.member.member.member_1;
            if ((_e539 & 256u) != 0u) {
                if select(!((_e320.member.x <= _e320.member_1.y)), true, ((bitcast<u32>(_e320.member_1.y) & 1u) == 1u)) {
                    phi_953_ = type_9(0u, _e382);
                    phi_956_ = _e536;
                    loop {
                        let _e550 = phi_953_;
                        let _e552 = phi_956_;
                        local_13 = _e552;
                        let _e555 = (_e550.member < _e550.member_1);
                        let _e566 = select(type_9().member_1, _e550.member, _e555);
                        let _e568 = (bitcast<i32>(select(0u, 1u, _e555)) != 0i);
                        if _e568 {
                            let _e571 = columns[(_e380 + _e566)];
                            phi_957_ = select(_e552, (_e552 & ~((1u << bitcast<u32>((_e566 & 31u))))), select(!((_e571.member[0] <= _e571.member_1[0])), true, ((bitcast<u32>(_e571.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_957_ = u32();
                        }
                        let _e589 = phi_957_;
                        continue;
                        continuing {
                            phi_953_ = type_9(select(_e550.member, (_e550.member + 1u), _e555), select(_e550.member_1, _e550.member_1, _e555));
                            phi_956_ = _e589;
                            break if !(_e568);
                        }
                    }
                    let _e885 = local_13;
                    phi_1021_ = _e885;
                } else {
                    phi_1021_ = _e536;
                }
                let _e592 = phi_1021_;
                phi_1022_ = _e592;
            } else {
                phi_1022_ = _e536;
            }
            let _e594 = phi_1022_;
            phi_1026_ = type_9(0u, _e382);
            phi_1029_ = _e594;
            loop {
                let _e597 = phi_1026_;
                let _e599 = phi_1029_;
                local_11 = _e599;
                local_12 = _e599;
                local_14 = _e599;
                let _e602 = (_e597.member < _e597.member_1);
                let _e613 = select(type_9().member_1, _e597.member, _e602);
                let _e615 = (bitcast<i32>(select(0u, 1u, _e602)) != 0i);
                if _e615 {
                    let _e618 = names[(_e380 + _e613)];
                    let _e621 = ranges[(_e380 + _e618)];
                    phi_1030_ = select((_e599 & ~((1u << bitcast<u32>((_e613 & 31u))))), _e599, select(false, ((_e621 >> bitcast<u32>(16i)) <= (_e215 & 65535u)), ((_e215 >> bitcast<u32>(16i)) <= (_e621 & 65535u))));
                } else {
                    phi_1030_ = u32();
                }
                let _e638 = phi_1030_;
                continue;
                continuing {
                    phi_1026_ = type_9(select(_e597.member, (_e597.member + 1u), _e602), select(_e597.member_1, _e597.member_1, _e602));
                    phi_1029_ = _e638;
                    break if !(_e615);
                }
            }
            let _e641 = local_11;
            let _e644 = atomicAdd((&counters[4u]), countOneBits(_e641));
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e647 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e647;
            }
            let _e650 = workgroupUniformLoad((&n_hits[0u]));
            let _e651 = (_e650 / 512u);
            phi_1115_ = type_9(0u, select(_e651, (_e651 + 1u), ((_e650 % 512u) > 0u)));
            loop {
                let _e658 = phi_1115_;
                let _e661 = (_e658.member < _e658.member_1);
                let _e674 = (bitcast<i32>(select(0u, 1u, _e661)) != 0i);
                if _e674 {
                    let _e675 = (_e47 / 32u);
                    let _e677 = (select(type_9().member_1, _e658.member, _e661) * 512u);
                    let _e685 = local_12;
                    if (_e685 == 0u) {
                    } else {
                        let _e688 = atomicLoad((&counters[_e675]));
                        let _e689 = (_e688 / 4u);
                        phi_1181_ = type_9(0u, select(_e689, (_e689 + 1u), ((_e688 % 4u) > 0u)));
                        phi_1184_ = (_e644 - _e677);
                        phi_1186_ = ((_e675 << bitcast<u32>(10i)) | ((_e47 % 32u) << bitcast<u32>(5i)));
                        let _e898 = local_14;
                        phi_1188_ = _e898;
                        loop {
                            let _e696 = phi_1181_;
                            let _e698 = phi_1184_;
                            let _e700 = phi_1186_;
                            let _e702 = phi_1188_;
                            let _e705 = (_e696.member < _e696.member_1);
                            let _e716 = (bitcast<i32>(select(0u, 1u, _e705)) != 0i);
                            if _e716 {
                                let _e717 = (_e702 & 1u);
                                if (_e717 == 0u) {
                                } else {
                                    if (_e698 < 512u) {
                                        hits[_e698] = _e700;
                                    }
                                }
                                let _e723 = select((_e698 + 1u), _e698, (_e717 == 0u));
                                let _e724 = (_e702 & 2u);
                                if (_e724 == 0u) {
                                } else {
                                    if (_e723 < 512u) {
                                        hits[_e723] = (_e700 + 1u);
                                    }
                                }
                                let _e731 = select((_e723 + 1u), _e723, (_e724 == 0u));
                                let _e732 = (_e702 & 4u);
                                if (_e732 == 0u) {
                                } else {
                                    if (_e731 < 512u) {
                                        hits[_e731] = (_e700 + 2u);
                                    }
                                }
                                let _e739 = select((_e731 + 1u), _e731, (_e732 == 0u));
                                let _e740 = (_e702 & 8u);
                                if (_e740 == 0u) {
                                } else {
                                    if (_e739 < 512u) {
                                        hits[_e739] = (_e700 + 3u);
                                    }
                                }
                                phi_1185_ = select((_e739 + 1u), _e739, (_e740 == 0u));
                                phi_1187_ = (_e700 + 4u);
                                phi_1189_ = (_e702 >> bitcast<u32>(4i));
                            } else {
                                phi_1185_ = u32();
                                phi_1187_ = u32();
                                phi_1189_ = u32();
                            }
                            let _e752 = phi_1185_;
                            let _e754 = phi_1187_;
                            let _e756 = phi_1189_;
                            continue;
                            continuing {
                                phi_1181_ = type_9(select(_e696.member, (_e696.member + 1u), _e705), select(_e696.member_1, _e696.member_1, _e705));
                                phi_1184_ = _e752;
                                phi_1186_ = _e754;
                                phi_1188_ = _e756;
                                break if !(_e716);
                            }
                        }
                    }
                    workgroupBarrier();
                    let _e759 = n_hits[0u];
                    let _e760 = (_e759 - _e677);
                    let _e762 = select(_e760, 512u, (512u < _e760));
                    if (_e47 == 0u) {
                        atomicStore((&counters[5u]), _e762);
                    }
                    workgroupBarrier();
                    if (_e47 == 0u) {
                        let _e767 = atomicLoad((&counters[5u]));
                        if (_e767 > 0u) {
                            let _e771 = params.member.member.member_1;
                            if ((_e771 & 1024u) != 0u) {
                                let _e781 = atomicAdd((&output.member[0u]), _e767);
                                let _e782 = (_e781 + _e767);
                                let _e784 = select(_e782, 4294967295u, (_e782 < _e781));
                                let _e787 = params.member.member_1.member_3;
                                if (_e784 > _e787) {
                                    let _e790 = atomicMax((&output.member[2u]), _e784);
                                }
                                phi_1351_ = _e781;
                            } else {
                                let _e775 = atomicAdd((&output.member[0u]), _e767);
                                if ((_e775 + _e767) < _e775) {
                                    let _e779 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1351_ = _e775;
                            }
                            let _e792 = phi_1351_;
                            atomicStore((&counters[6u]), _e792);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e796 = atomicLoad((&counters[6u]));
                    phi_1358_ = type_9(0u, 4u);
                    loop {
                        let _e798 = phi_1358_;
                        let _e801 = (_e798.member < _e798.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e801)) != 0i) {
                            let _e816 = (_e47 + (select(type_9().member_1, _e798.member, _e801) * 128u));
                            if (_e816 >= _e762) {
                                phi_1431_ = false;
                            } else {
                                let _e819 = hits[_e816];
                                let _e822 = ((_e819 >> bitcast<u32>(10i)) & 3u);
                                let _e830 = names[((_e822 * 32u) + (_e819 & 31u))];
                                let _e833 = firsts[(2u * _e822)];
                                let _e838 = firsts[((2u * _e822) + 1u)];
                                let _e842 = params.member.member_1.member_3;
                                let _e843 = (_e796 + _e816);
                                if (_e843 < _e842) {
                                    let _e845 = (2u * _e843);
                                    atomicStore((&output.member[(4u + _e845)]), (_e833 + ((_e819 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e845 + 5u)]), (_e838 + _e830));
                                }
                                phi_1431_ = true;
                            }
                            let _e851 = phi_1431_;
                            phi_1432_ = _e851;
                        } else {
                            phi_1432_ = false;
                        }
                        let _e853 = phi_1432_;
                        continue;
                        continuing {
                            phi_1358_ = type_9(select(_e798.member, (_e798.member + 1u), _e801), select(_e798.member_1, _e798.member_1, _e801));
                            break if !(_e853);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1115_ = type_9(select(_e658.member, (_e658.member + 1u), _e661), select(_e658.member_1, _e658.member_1, _e661));
                    break if !(_e674);
                }
            }
            phi_223_ = (_e103 + (_e46.x * _e46.y));
        } else {
            phi_223_ = u32();
        }
        let _e857 = phi_223_;
        continue;
        continuing {
            phi_222_ = _e857;
            break if !(_e109);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
