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
    var phi_154_: u32;
    var phi_181_: u32;
    var phi_211_: u32;
    var phi_478_: bool;
    var phi_516_: type_24;
    var phi_551_: type_9;
    var phi_554_: u32;
    var phi_555_: u32;
    var local: u32;
    var local_1: u32;
    var phi_796_: type_9;
    var phi_799_: u32;
    var phi_800_: u32;
    var phi_864_: u32;
    var phi_865_: u32;
    var phi_872_: type_9;
    var phi_875_: u32;
    var phi_876_: u32;
    var phi_945_: u32;
    var phi_977_: type_9;
    var phi_1039_: type_9;
    var phi_1042_: u32;
    var phi_1043_: u32;
    var phi_1216_: u32;
    var phi_1223_: type_9;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_212_: u32;
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
    let _e54 = params.member.member_1.member_2;
    let _e56 = input.member[0u];
    let _e58 = select(_e56, _e54, (_e54 < _e56));
    let _e61 = params.member.member_1.member_1;
    if (_e58 > _e61) {
        let _e65 = params.member.member_1.member_1;
        phi_154_ = (_e58 - _e65);
    } else {
        phi_154_ = 0u;
    }
    let _e68 = phi_154_;
    let _e71 = params.member.member_2.member_3;
    if (_e71 == 1u) {
        phi_181_ = _e68;
    } else {
        let _e75 = params.member.member_2.member_3;
        if (_e75 == 0u) {
            return;
        }
        let _e77 = (_e68 / _e75);
        if (_e75 == 0u) {
            return;
        }
        phi_181_ = select(_e77, (_e77 + 1u), ((_e68 % _e75) > 0u));
    }
    let _e84 = phi_181_;
    let _e87 = params.member.member_2.member_4;
    let _e89 = select(_e84, _e87, (_e87 < _e84));
    let _e90 = (_e39 / 32u);
    phi_211_ = ((_e37.y * _e38.x) + _e37.x);
    loop {
        let _e93 = phi_211_;
        let _e94 = (_e89 / 4u);
        let _e99 = (_e93 < select(_e94, (_e94 + 1u), ((_e89 % 4u) > 0u)));
        if _e99 {
            let _e102 = ((_e93 * 4u) + (_e39 / 32u));
            let _e103 = (_e102 < _e89);
            let _e106 = params.member.member_1.member_1;
            let _e109 = params.member.member_2.member_3;
            let _e113 = (2u * (_e106 + select(0u, (_e102 * _e109), _e103)));
            let _e116 = input.member[(4u + _e113)];
            let _e119 = input.member[(_e113 + 5u)];
            if (_e39 <= 5u) {
                atomicStore((&counters[_e39]), 0u);
            }
            workgroupBarrier();
            if ((_e39 % 32u) == 0u) {
                firsts[(2u * _e90)] = (_e116 * 32u);
                firsts[((2u * _e90) + 1u)] = (_e119 * 32u);
            }
            let _e133 = params.member.member_2.member_1;
            let _e134 = (_e133 == 0u);
            let _e135 = select(1u, 0u, _e134);
            let _e136 = select(1u, 2u, _e134);
            let _e137 = (_e39 / 32u);
            let _e138 = (_e39 % 32u);
            let _e140 = params.member.member_2.member_2;
            let _e144 = params.member.member_2.member[_e140][_e135];
            let _e147 = nodes.member[(_e144 + _e116)];
            let _e161 = params.member.member_2.member_2;
            let _e165 = params.member.member_2.member[_e161][_e136];
            let _e168 = nodes.member[(_e165 + _e119)];
            let _e182 = params.member.member_2.member_2;
            let _e189 = params.member.member_2.member[(_e182 - 1u)][_e135];
            let _e192 = nodes.member[(_e189 + ((_e116 * 32u) + _e138))];
            let _e209 = params.member.member_2.member_2;
            let _e216 = params.member.member_2.member[(_e209 - 1u)][_e136];
            let _e219 = nodes.member[(_e216 + ((_e119 * 32u) + _e138))];
            if _e103 {
                phi_478_ = ((((((_e192.member.x <= _e168.member_1.y) && (_e168.member.x <= _e192.member_1.y)) && (_e192.member.y <= _e168.member_2.x)) && (_e168.member.y <= _e192.member_2.x)) && (_e192.member_1.x <= _e168.member_2.y)) && (_e168.member_1.x <= _e192.member_2.y));
            } else {
                phi_478_ = false;
            }
            let _e244 = phi_478_;
            if _e103 {
                if ((((((_e219.member.x <= _e147.member_1.y) && (_e147.member.x <= _e219.member_1.y)) && (_e219.member.y <= _e147.member_2.x)) && (_e147.member.y <= _e219.member_2.x)) && (_e219.member_1.x <= _e147.member_2.y)) && (_e147.member_1.x <= _e219.member_2.y)) {
                    let _e258 = atomicAdd((&counters[_e137]), 1u);
                    let _e259 = ((_e137 * 32u) + _e258);
                    columns[_e259] = type_24(array<f32, 3>(_e219.member.x, _e219.member.y, _e219.member_1.x), array<f32, 3>(_e219.member_1.y, _e219.member_2.x, _e219.member_2.y));
                    names[_e259] = _e138;
                }
            }
            if _e244 {
                phi_516_ = type_24(array<f32, 3>(_e192.member.x, _e192.member.y, _e192.member_1.x), array<f32, 3>(_e192.member_1.y, _e192.member_2.x, _e192.member_2.y));
            } else {
                phi_516_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e266 = phi_516_;
            workgroupBarrier();
            let _e269 = params.member.member_2.member_1;
            let _e272 = select(false, (_e116 == _e119), (_e269 == 1u));
            let _e273 = (_e39 / 32u);
            let _e274 = (_e39 % 32u);
            let _e275 = (_e273 * 32u);
            let _e277 = atomicLoad((&counters[_e273]));
            let _e278 = (_e277 / 4u);
            phi_551_ = type_9(0u, select(_e278, (_e278 + 1u), ((_e277 % 4u) > 0u)));
            phi_554_ = 0u;
            loop {
                let _e285 = phi_551_;
                let _e287 = phi_554_;
                local = _e287;
                local_1 = _e287;
                let _e290 = (_e285.member < _e285.member_1);
                let _e303 = (bitcast<i32>(select(0u, 1u, _e290)) != 0i);
                if _e303 {
                    let _e304 = (4u * select(type_9().member_1, _e285.member, _e290));
                    let _e307 = columns[(_e275 + _e304)];
                    let _e346 = columns[((_e275 + _e304) + 1u)];
                    let _e387 = columns[((_e275 + _e304) + 2u)];
                    let _e428 = columns[((_e275 + _e304) + 3u)];
                    phi_555_ = (_e287 | ((((select(0u, 1u, ((((((_e266.member[0] <= _e307.member_1[0]) && (_e307.member[0] <= _e266.member_1[0])) && (_e266.member[1] <= _e307.member_1[1])) && (_e307.member[1] <= _e266.member_1[1])) && (_e266.member[2] <= _e307.member_1[2])) && (_e307.member[2] <= _e266.member_1[2]))) << bitcast<u32>((_e304 & 31u))) | (select(0u, 1u, ((((((_e266.member[0] <= _e346.member_1[0]) && (_e346.member[0] <= _e266.member_1[0])) && (_e266.member[1] <= _e346.member_1[1])) && (_e346.member[1] <= _e266.member_1[1])) && (_e266.member[2] <= _e346.member_1[2])) && (_e346.member[2] <= _e266.member_1[2]))) << bitcast<u32>(((_e304 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e266.member[0] <= _e387.member_1[0]) && (_e387.member[0] <= _e266.member_1[0])) && (_e266.member[1] <= _e387.member_1[1])) && (_e387.member[1] <= _e266.member_1[1])) && (_e266.member[2] <= _e387.member_1[2])) && (_e387.member[2] <= _e266.member_1[2]))) << bitcast<u32>(((_e304 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e266.member[0] <= _e428.member_1[0]) && (_e428.member[0] <= _e266.member_1[0])) && (_e266.member[1] <= _e428.member_1[1])) && (_e428.member[1] <= _e266.member_1[1])) && (_e266.member[2] <= _e428.member_1[2])) && (_e428.member[2] <= _e266.member_1[2]))) << bitcast<u32>(((_e304 + 3u) & 31u)))));
                } else {
                    phi_555_ = u32();
                }
                let _e468 = phi_555_;
                continue;
                continuing {
                    phi_551_ = type_9(select(_e285.member, (_e285.member + 1u), _e290), select(_e285.member_1, _e285.member_1, _e290));
                    phi_554_ = _e468;
                    break if !(_e303);
                }
            }
            let _e476 = local;
            let _e479 = local_1;
            let _e480 = select(_e479, (_e476 & ((1u << bitcast<u32>((_e277 & 31u))) - 1u)), (_e277 < 32u));
            let _e483 = params.member.member.member_1;
            if ((_e483 & 256u) != 0u) {
                if select(!((_e266.member[0] <= _e266.member_1[0])), true, ((bitcast<u32>(_e266.member_1[0]) & 1u) == 1u)) {
                    phi_796_ = type_9(0u, _e277);
                    phi_799_ = _e480;
                    loop {
                        let _e500 = phi_796_;
                        let _e502 = phi_799_;
                        local_2 = _e502;
                        let _e505 = (_e500.member < _e500.member_1);
                        let _e516 = select(type_9().member_1, _e500.member, _e505);
                        let _e518 = (bitcast<i32>(select(0u, 1u, _e505)) != 0i);
                        if _e518 {
                            let _e521 = columns[(_e275 + _e516)];
                            phi_800_ = select(_e502, (_e502 & ~((1u << bitcast<u32>((_e516 & 31u))))), select(!((_e521.member[0] <= _e521.member_1[0])), true, ((bitcast<u32>(_e521.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_800_ = u32();
                        }
                        let _e539 = phi_800_;
                        continue;
                        continuing {
                            phi_796_ = type_9(select(_e500.member, (_e500.member + 1u), _e505), select(_e500.member_1, _e500.member_1, _e505));
                            phi_799_ = _e539;
                            break if !(_e518);
                        }
                    }
                    let _e824 = local_2;
                    phi_864_ = _e824;
                } else {
                    phi_864_ = _e480;
                }
                let _e542 = phi_864_;
                phi_865_ = _e542;
            } else {
                phi_865_ = _e480;
            }
            let _e544 = phi_865_;
            if _e272 {
                phi_872_ = type_9(0u, _e277);
                phi_875_ = _e544;
                loop {
                    let _e547 = phi_872_;
                    let _e549 = phi_875_;
                    local_3 = _e549;
                    let _e552 = (_e547.member < _e547.member_1);
                    let _e563 = select(type_9().member_1, _e547.member, _e552);
                    let _e565 = (bitcast<i32>(select(0u, 1u, _e552)) != 0i);
                    if _e565 {
                        let _e568 = names[(_e275 + _e563)];
                        let _e569 = (_e274 < _e568);
                        phi_876_ = select(_e549, (_e549 & ~((1u << bitcast<u32>((_e563 & 31u))))), select(true, false, select(select(bool(), select(select(false, true, (_e274 == _e568)), bool(), _e569), _e272), true, select(true, _e569, _e272))));
                    } else {
                        phi_876_ = u32();
                    }
                    let _e584 = phi_876_;
                    continue;
                    continuing {
                        phi_872_ = type_9(select(_e547.member, (_e547.member + 1u), _e552), select(_e547.member_1, _e547.member_1, _e552));
                        phi_875_ = _e584;
                        break if !(_e565);
                    }
                }
                let _e831 = local_3;
                phi_945_ = _e831;
            } else {
                phi_945_ = _e544;
            }
            let _e587 = phi_945_;
            let _e590 = atomicAdd((&counters[4u]), countOneBits(_e587));
            workgroupBarrier();
            if (_e39 == 0u) {
                let _e593 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e593;
            }
            let _e596 = workgroupUniformLoad((&n_hits[0u]));
            let _e597 = (_e596 / 512u);
            phi_977_ = type_9(0u, select(_e597, (_e597 + 1u), ((_e596 % 512u) > 0u)));
            loop {
                let _e604 = phi_977_;
                let _e607 = (_e604.member < _e604.member_1);
                let _e620 = (bitcast<i32>(select(0u, 1u, _e607)) != 0i);
                if _e620 {
                    let _e621 = (_e39 / 32u);
                    let _e627 = ((_e621 << bitcast<u32>(10i)) | ((_e39 % 32u) << bitcast<u32>(5i)));
                    let _e628 = (select(type_9().member_1, _e604.member, _e607) * 512u);
                    let _e631 = atomicLoad((&counters[_e621]));
                    let _e632 = (_e631 / 4u);
                    phi_1039_ = type_9(0u, select(_e632, (_e632 + 1u), ((_e631 % 4u) > 0u)));
                    phi_1042_ = (_e590 - _e628);
                    loop {
                        let _e639 = phi_1039_;
                        let _e641 = phi_1042_;
                        let _e644 = (_e639.member < _e639.member_1);
                        let _e657 = (bitcast<i32>(select(0u, 1u, _e644)) != 0i);
                        if _e657 {
                            let _e658 = (4u * select(type_9().member_1, _e639.member, _e644));
                            let _e664 = (((_e587 >> bitcast<u32>((_e658 & 31u))) & 1u) == 1u);
                            if _e664 {
                                if (_e641 < 512u) {
                                    hits[_e641] = (_e627 + _e658);
                                }
                            }
                            let _e668 = select(_e641, (_e641 + 1u), _e664);
                            let _e676 = (((_e587 >> bitcast<u32>(((_e658 + 1u) & 31u))) & 1u) == 1u);
                            if _e676 {
                                if (_e668 < 512u) {
                                    hits[_e668] = ((_e627 + _e658) + 1u);
                                }
                            }
                            let _e680 = select(_e668, (_e668 + 1u), _e676);
                            let _e688 = (((_e587 >> bitcast<u32>(((_e658 + 2u) & 31u))) & 1u) == 1u);
                            if _e688 {
                                if (_e680 < 512u) {
                                    hits[_e680] = ((_e627 + _e658) + 2u);
                                }
                            }
                            let _e692 = select(_e680, (_e680 + 1u), _e688);
                            let _e700 = (((_e587 >> bitcast<u32>(((_e658 + 3u) & 31u))) & 1u) == 1u);
                            if _e700 {
                                if (_e692 < 512u) {
                                    hits[_e692] = ((_e627 + _e658) + 3u);
                                }
                            }
                            phi_1043_ = select(_e692, (_e692 + 1u), _e700);
                        } else {
                            phi_1043_ = u32();
                        }
                        let _e706 = phi_1043_;
                        continue;
                        continuing {
                            phi_1039_ = type_9(select(_e639.member, (_e639.member + 1u), _e644), select(_e639.member_1, _e639.member_1, _e644));
                            phi_1042_ = _e706;
                            break if !(_e657);
                        }
                    }
                    workgroupBarrier();
                    let _e709 = n_hits[0u];
                    let _e710 = (_e709 - _e628);
                    let _e712 = select(_e710, 512u, (512u < _e710));
                    if (_e39 == 0u) {
                        atomicStore((&counters[5u]), _e712);
                    }
                    workgroupBarrier();
                    if (_e39 == 0u) {
                        let _e717 = atomicLoad((&counters[5u]));
                        if (_e717 > 0u) {
                            let _e721 = params.member.member.member_1;
                            if ((_e721 & 1024u) != 0u) {
                                let _e731 = atomicAdd((&output.member[0u]), _e717);
                                let _e732 = (_e731 + _e717);
                                let _e734 = select(_e732, 4294967295u, (_e732 < _e731));
                                let _e737 = params.member.member_1.member_3;
                                if (_e734 > _e737) {
                                    let _e740 = atomicMax((&output.member[2u]), _e734);
                                }
                                phi_1216_ = _e731;
                            } else {
                                let _e725 = atomicAdd((&output.member[0u]), _e717);
                                if ((_e725 + _e717) < _e725) {
                                    let _e729 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1216_ = _e725;
                            }
                            let _e742 = phi_1216_;
                            atomicStore((&counters[6u]), _e742);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e746 = atomicLoad((&counters[6u]));
                    phi_1223_ = type_9(0u, 4u);
                    loop {
                        let _e748 = phi_1223_;
                        let _e751 = (_e748.member < _e748.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e751)) != 0i) {
                            let _e766 = (_e39 + (select(type_9().member_1, _e748.member, _e751) * 128u));
                            if (_e766 >= _e712) {
                                phi_1296_ = false;
                            } else {
                                let _e769 = hits[_e766];
                                let _e772 = ((_e769 >> bitcast<u32>(10i)) & 3u);
                                let _e780 = names[((_e772 * 32u) + (_e769 & 31u))];
                                let _e783 = firsts[(2u * _e772)];
                                let _e788 = firsts[((2u * _e772) + 1u)];
                                let _e792 = params.member.member_1.member_3;
                                let _e793 = (_e746 + _e766);
                                if (_e793 < _e792) {
                                    let _e795 = (2u * _e793);
                                    atomicStore((&output.member[(4u + _e795)]), (_e783 + ((_e769 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e795 + 5u)]), (_e788 + _e780));
                                }
                                phi_1296_ = true;
                            }
                            let _e801 = phi_1296_;
                            phi_1297_ = _e801;
                        } else {
                            phi_1297_ = false;
                        }
                        let _e803 = phi_1297_;
                        continue;
                        continuing {
                            phi_1223_ = type_9(select(_e748.member, (_e748.member + 1u), _e751), select(_e748.member_1, _e748.member_1, _e751));
                            break if !(_e803);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_977_ = type_9(select(_e604.member, (_e604.member + 1u), _e607), select(_e604.member_1, _e604.member_1, _e607));
                    break if !(_e620);
                }
            }
            phi_212_ = (_e93 + (_e38.x * _e38.y));
        } else {
            phi_212_ = u32();
        }
        let _e807 = phi_212_;
        continue;
        continuing {
            phi_211_ = _e807;
            break if !(_e99);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
