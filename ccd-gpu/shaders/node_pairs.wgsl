struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_11 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 4>, 8>,
}

struct type_13 {
    member: type_11,
}

struct type_17 {
    member: array<type_6>,
}

struct type_21 {
    member: array<u32>,
}

struct type_30 {
    member: i32,
    member_1: i32,
}

struct type_31 {
    member: u32,
    member_1: i32,
}

struct type_32 {
    member: u32,
    member_1: u32,
}

struct type_44 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> nodes: type_17;
@group(0) @binding(2) 
var<storage> input: type_21;
@group(0) @binding(3) 
var<storage, read_write> output: type_44;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> sides: array<type_6, 64>;
var<workgroup> names: array<u32, 64>;
var<workgroup> hits: array<u32, 1024>;

fn function_() {
    var phi_122_: u32;
    var phi_149_: u32;
    var phi_150_: u32;
    var phi_157_: u32;
    var phi_178_: u32;
    var phi_179_: u32;
    var phi_182_: type_32;
    var phi_183_: type_32;
    var phi_206_: type_32;
    var phi_258_: array<u32, 2>;
    var phi_266_: u32;
    var phi_267_: u32;
    var phi_272_: u32;
    var phi_273_: u32;
    var phi_391_: u32;
    var phi_422_: bool;
    var phi_427_: type_32;
    var phi_430_: u32;
    var phi_428_: type_32;
    var phi_453_: type_32;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_536_: u32;
    var phi_537_: bool;
    var phi_431_: u32;
    var phi_538_: bool;
    var phi_564_: type_30;
    var phi_567_: u32;
    var phi_588_: bool;
    var phi_594_: type_31;
    var phi_565_: type_30;
    var phi_608_: type_31;
    var phi_644_: u32;
    var phi_645_: bool;
    var phi_568_: u32;
    var phi_646_: bool;

    let _e45 = id_1;
    let _e46 = n_1;
    let _e47 = lane_1;
    let _e56 = ((_e45.y * _e46.x) + _e45.x);
    let _e59 = (_e46.x * _e46.y);
    let _e61 = params.member.member_15;
    let _e63 = input.member[0u];
    if (_e61 < _e63) {
        phi_122_ = _e61;
    } else {
        phi_122_ = _e63;
    }
    let _e66 = phi_122_;
    let _e68 = params.member.member_12;
    if (_e66 > _e68) {
        let _e71 = params.member.member_12;
        let _e72 = (_e66 - _e71);
        let _e74 = params.member.member_13;
        if (_e74 == 0u) {
            return;
        }
        let _e76 = (_e72 / _e74);
        if (_e74 == 0u) {
            return;
        }
        if ((_e72 % _e74) > 0u) {
            phi_149_ = (_e76 + 1u);
        } else {
            phi_149_ = _e76;
        }
        let _e82 = phi_149_;
        phi_150_ = _e82;
    } else {
        phi_150_ = 0u;
    }
    let _e84 = phi_150_;
    let _e86 = params.member.member_14;
    if (_e86 < _e84) {
        phi_157_ = _e86;
    } else {
        phi_157_ = _e84;
    }
    let _e89 = phi_157_;
    if (_e89 > _e56) {
        let _e91 = (_e89 - _e56);
        if (_e59 == 0u) {
            return;
        }
        let _e93 = (_e91 / _e59);
        if (_e59 == 0u) {
            return;
        }
        if ((_e91 % _e59) > 0u) {
            phi_178_ = (_e93 + 1u);
        } else {
            phi_178_ = _e93;
        }
        let _e99 = phi_178_;
        phi_179_ = _e99;
    } else {
        phi_179_ = 0u;
    }
    let _e101 = phi_179_;
    phi_182_ = type_32(0u, _e101);
    loop {
        let _e104 = phi_182_;
        if (_e104.member < _e104.member_1) {
            phi_183_ = type_32((_e104.member + 1u), _e104.member_1);
            phi_206_ = type_32(1u, _e104.member);
        } else {
            phi_183_ = _e104;
            phi_206_ = type_32(0u, type_32().member_1);
        }
        let _e118 = phi_183_;
        let _e120 = phi_206_;
        let _e124 = (bitcast<i32>(_e120.member) != 0i);
        if _e124 {
            let _e126 = params.member.member_12;
            let _e130 = params.member.member_13;
            let _e133 = (2u * (_e126 + ((_e56 + (_e120.member_1 * _e59)) * _e130)));
            let _e136 = input.member[(4u + _e133)];
            let _e139 = input.member[(_e133 + 5u)];
            if (_e47 < 8u) {
                atomicStore((&counters[_e47]), 0u);
            }
            workgroupBarrier();
            let _e143 = params.member.member_8;
            if (_e143 == 0u) {
                phi_258_ = array<u32, 2>(0u, 2u);
            } else {
                phi_258_ = array<u32, 2>(1u, 1u);
            }
            let _e146 = phi_258_;
            let _e149 = (_e47 / 32u);
            if (_e149 == 0u) {
                phi_266_ = _e146[0];
                phi_267_ = _e136;
            } else {
                phi_266_ = _e146[1];
                phi_267_ = _e139;
            }
            let _e152 = phi_266_;
            let _e154 = phi_267_;
            if (_e149 == 0u) {
                phi_272_ = _e139;
                phi_273_ = _e146[1];
            } else {
                phi_272_ = _e136;
                phi_273_ = _e146[0];
            }
            let _e157 = phi_272_;
            let _e159 = phi_273_;
            let _e161 = params.member.member_9;
            let _e162 = (_e161 - 1u);
            if (_e162 < 8u) {
            } else {
                return;
            }
            if (_e152 < 4u) {
            } else {
                return;
            }
            let _e171 = params.member.member_18[_e162][_e152];
            let _e174 = nodes.member[(_e171 + ((_e154 * 32u) + (_e47 % 32u)))];
            let _e176 = params.member.member_9;
            if (_e176 < 8u) {
            } else {
                return;
            }
            if (_e159 < 4u) {
            } else {
                return;
            }
            let _e182 = params.member.member_18[_e176][_e159];
            let _e185 = nodes.member[(_e182 + _e157)];
            if ((((((_e174.member[0] <= _e185.member_1[0]) && (_e185.member[0] <= _e174.member_1[0])) && (_e174.member[1] <= _e185.member_1[1])) && (_e185.member[1] <= _e174.member_1[1])) && (_e174.member[2] <= _e185.member_1[2])) && (_e185.member[2] <= _e174.member_1[2])) {
                let _e223 = atomicAdd((&counters[_e149]), 1u);
                let _e224 = ((_e149 * 32u) + _e223);
                sides[_e224] = type_6(array<f32, 3>(_e174.member[0], _e174.member[1], _e174.member[2]), array<f32, 3>(_e174.member_1[0], _e174.member_1[1], _e174.member_1[2]));
                names[_e224] = (_e47 % 32u);
            }
            workgroupBarrier();
            let _e240 = atomicLoad((&counters[0u]));
            let _e242 = atomicLoad((&counters[1u]));
            if (_e240 <= 1u) {
                phi_391_ = 0u;
            } else {
                let _e244 = (_e240 - 1u);
                phi_391_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e244)), 32u, (_e244 == 0u)));
            }
            let _e252 = phi_391_;
            let _e257 = (_e47 & ((1u << bitcast<u32>((_e252 & 31u))) - 1u));
            if (_e257 < _e240) {
                let _e260 = sides[_e257];
                let _e270 = names[_e257];
                let _e272 = params.member.member_8;
                if (_e272 == 1u) {
                    phi_422_ = (_e136 == _e139);
                } else {
                    phi_422_ = false;
                }
                let _e276 = phi_422_;
                phi_427_ = type_32(0u, 32u);
                phi_430_ = (_e47 >> bitcast<u32>((_e252 & 31u)));
                loop {
                    let _e281 = phi_427_;
                    let _e283 = phi_430_;
                    if (_e281.member < _e281.member_1) {
                        phi_428_ = type_32((_e281.member + 1u), _e281.member_1);
                        phi_453_ = type_32(1u, _e281.member);
                    } else {
                        phi_428_ = _e281;
                        phi_453_ = type_32(0u, type_32().member_1);
                    }
                    let _e297 = phi_428_;
                    let _e299 = phi_453_;
                    if (bitcast<i32>(_e299.member) != 0i) {
                        if (_e283 >= _e242) {
                            phi_536_ = u32();
                            phi_537_ = false;
                        } else {
                            let _e306 = sides[(32u + _e283)];
                            if ((((((_e260.member[0] <= _e306.member_1[0]) && (_e306.member[0] <= _e260.member_1[0])) && (_e260.member[1] <= _e306.member_1[1])) && (_e306.member[1] <= _e260.member_1[1])) && (_e260.member[2] <= _e306.member_1[2])) && (_e306.member[2] <= _e260.member_1[2])) {
                                let _e328 = names[(32u + _e283)];
                                if _e276 {
                                    if (_e270 < _e328) {
                                        phi_523_ = true;
                                    } else {
                                        if (_e270 == _e328) {
                                            phi_522_ = true;
                                        } else {
                                            phi_522_ = false;
                                        }
                                        let _e332 = phi_522_;
                                        phi_523_ = _e332;
                                    }
                                    let _e334 = phi_523_;
                                    phi_524_ = _e334;
                                } else {
                                    phi_524_ = true;
                                }
                                let _e336 = phi_524_;
                                if _e336 {
                                    let _e338 = atomicAdd((&counters[2u]), 1u);
                                    hits[_e338] = ((_e270 << bitcast<u32>(5i)) | _e328);
                                }
                            }
                            phi_536_ = (_e283 + (64u >> bitcast<u32>((_e252 & 31u))));
                            phi_537_ = true;
                        }
                        let _e348 = phi_536_;
                        let _e350 = phi_537_;
                        phi_431_ = _e348;
                        phi_538_ = _e350;
                    } else {
                        phi_431_ = u32();
                        phi_538_ = false;
                    }
                    let _e352 = phi_431_;
                    let _e354 = phi_538_;
                    continue;
                    continuing {
                        phi_427_ = _e297;
                        phi_430_ = _e352;
                        break if !(_e354);
                    }
                }
            }
            workgroupBarrier();
            let _e357 = atomicLoad((&counters[2u]));
            if (_e47 == 0u) {
                atomicStore((&counters[3u]), _e357);
            }
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e362 = atomicLoad((&counters[3u]));
                if (_e362 > 0u) {
                    let _e365 = atomicAdd((&output.member[0u]), _e362);
                    atomicStore((&counters[4u]), _e365);
                }
            }
            workgroupBarrier();
            let _e368 = atomicLoad((&counters[4u]));
            phi_564_ = type_30(0i, 16i);
            phi_567_ = _e47;
            loop {
                let _e370 = phi_564_;
                let _e372 = phi_567_;
                if (_e370.member < _e370.member_1) {
                    let _e380 = (_e370.member + 1i);
                    if ((false == (_e380 > _e370.member)) != false) {
                        phi_588_ = true;
                    } else {
                        phi_588_ = false;
                    }
                    let _e385 = phi_588_;
                    if _e385 {
                        phi_594_ = type_31(0u, type_31().member_1);
                    } else {
                        phi_594_ = type_31(1u, _e380);
                    }
                    let _e391 = phi_594_;
                    if (bitcast<i32>(_e391.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_565_ = type_30(_e391.member_1, _e370.member_1);
                    phi_608_ = type_31(1u, _e370.member);
                } else {
                    phi_565_ = _e370;
                    phi_608_ = type_31(0u, type_31().member_1);
                }
                let _e401 = phi_565_;
                let _e403 = phi_608_;
                if (bitcast<i32>(_e403.member) != 0i) {
                    if (_e372 >= _e357) {
                        phi_644_ = u32();
                        phi_645_ = false;
                    } else {
                        let _e409 = hits[_e372];
                        let _e414 = params.member.member_16;
                        let _e415 = (_e368 + _e372);
                        if (_e415 < _e414) {
                            atomicStore((&output.member[(4u + (2u * _e415))]), ((_e136 * 32u) + (_e409 >> bitcast<u32>(5i))));
                            atomicStore((&output.member[((2u * _e415) + 5u)]), ((_e139 * 32u) + (_e409 & 31u)));
                        }
                        phi_644_ = (_e372 + 64u);
                        phi_645_ = true;
                    }
                    let _e429 = phi_644_;
                    let _e431 = phi_645_;
                    phi_568_ = _e429;
                    phi_646_ = _e431;
                } else {
                    phi_568_ = u32();
                    phi_646_ = false;
                }
                let _e433 = phi_568_;
                let _e435 = phi_646_;
                continue;
                continuing {
                    phi_564_ = _e401;
                    phi_567_ = _e433;
                    break if !(_e435);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_182_ = _e118;
            break if !(_e124);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
