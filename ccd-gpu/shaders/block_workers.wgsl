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

struct type_17 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
    member_18: u32,
}

struct type_25 {
    member: type_22,
    member_1: array<array<u32, 2>, 8>,
}

struct type_26 {
    member: type_7,
    member_1: type_8,
    member_2: type_25,
}

struct type_27 {
    member: type_26,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_30;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
var<workgroup> sums: array<u32, 256>;
@group(0) @binding(0) 
var<storage> params: type_27;
@group(0) @binding(2) 
var<storage, read_write> control: type_30;
@group(0) @binding(3) 
var<storage, read_write> nodes: type_30;
@group(0) @binding(5) 
var<storage, read_write> front: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_215_: type_9;
    var phi_299_: u32;
    var phi_300_: u32;
    var phi_436_: u32;
    var phi_437_: u32;
    var phi_438_: u32;
    var phi_439_: u32;
    var phi_440_: u32;
    var phi_460_: u32;
    var phi_461_: u32;
    var phi_475_: type_9;
    var phi_582_: array<u32, 2>;
    var phi_583_: array<u32, 2>;
    var phi_832_: type_21;
    var phi_833_: bool;
    var phi_834_: type_21;
    var phi_835_: bool;
    var phi_913_: type_9;
    var phi_916_: u32;
    var phi_918_: u32;
    var phi_998_: u32;
    var phi_999_: u32;
    var phi_1000_: bool;
    var phi_917_: u32;
    var phi_919_: u32;
    var phi_1001_: bool;
    var phi_1002_: u32;
    var phi_1014_: u32;
    var phi_1015_: u32;
    var phi_1217_: array<u32, 3>;
    var phi_1235_: array<u32, 3>;
    var phi_1246_: array<u32, 3>;
    var phi_1257_: array<u32, 3>;
    var phi_1037_: array<u32, 3>;
    var phi_1052_: type_9;
    var phi_1055_: u32;
    var phi_1057_: u32;
    var phi_1059_: u32;
    var phi_1056_: u32;
    var phi_1098_: u32;
    var phi_1058_: u32;
    var phi_1060_: u32;
    var local: u32;
    var phi_1126_: type_9;
    var phi_1129_: u32;
    var phi_1131_: u32;
    var phi_1133_: u32;
    var phi_1130_: u32;
    var phi_1172_: u32;
    var phi_1132_: u32;
    var phi_1134_: u32;
    var local_1: u32;
    var phi_1187_: u32;
    var phi_1272_: array<u32, 2>;
    var phi_1406_: type_9;
    var phi_1409_: u32;
    var phi_1411_: u32;
    var phi_1413_: u32;
    var phi_1567_: u32;
    var phi_1568_: u32;
    var phi_1569_: u32;
    var phi_1570_: bool;
    var phi_1410_: u32;
    var phi_1412_: u32;
    var phi_1414_: u32;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1601_: u32;
    var phi_1721_: type_9;
    var phi_1839_: type_9;
    var phi_1944_: type_9;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var local_2: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e63 = id_2;
    let _e64 = n_2;
    let _e65 = lane_2;
    let _e76 = ((_e63.y * _e64.x) + _e63.x);
    let _e79 = params.member.member_2.member;
    let _e81 = params.member.member_1;
    let _e84 = (_e81.member_1 % 2u);
    let _e86 = atomicLoad((&control.member[_e81.member_1]));
    let _e88 = select(_e86, _e79.member_3, (_e79.member_3 < _e86));
    let _e89 = (_e84 * _e79.member_3);
    let _e91 = ((1u - _e84) * _e79.member_3);
    if (_e65 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_215_ = type_9(0u, _e79.member_12);
    loop {
        let _e100 = phi_215_;
        let _e103 = (_e100.member < _e100.member_1);
        if (bitcast<i32>(select(0u, 1u, _e103)) != 0i) {
            if (_e65 == 0u) {
                let _e123 = atomicLoad((&shared_[0u]));
                let _e125 = select(_e123, 4u, (4u < _e123));
                if (_e79.member_9 > 0u) {
                    if (select(type_9().member_1, _e100.member, _e103) >= 16u) {
                        let _e130 = atomicLoad((&control.member[(1024u + _e81.member_1)]));
                        phi_299_ = select(0u, 2u, select(false, ((_e130 * 100u) >= (_e79.member_9 << bitcast<u32>((_e79.member_7 & 31u)))), (_e79.member_9 > 0u)));
                    } else {
                        phi_299_ = 0u;
                    }
                    let _e140 = phi_299_;
                    phi_300_ = _e140;
                } else {
                    phi_300_ = 0u;
                }
                let _e142 = phi_300_;
                let _e143 = (4u - _e125);
                if (_e142 == 0u) {
                    if (_e143 > 0u) {
                        let _e147 = atomicLoad((&shared_[5u]));
                        if (_e79.member_6 == 0u) {
                            let _e208 = (select(0u, ((((_e88 - 1u) - _e76) >> bitcast<u32>((_e79.member_7 & 31u))) + 1u), (_e76 < _e88)) - _e147);
                            let _e210 = select(_e208, _e143, (_e143 < _e208));
                            atomicStore((&shared_[3u]), (_e76 + (_e147 << bitcast<u32>((_e79.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e79.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e147 + _e210));
                            phi_438_ = _e210;
                        } else {
                            if (_e79.member_6 == 2u) {
                                let _e183 = (((_e88 + (1u << bitcast<u32>((_e79.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e79.member_7 & 31u)));
                                let _e184 = (_e76 * _e183);
                                let _e186 = select(_e184, _e88, (_e88 < _e184));
                                let _e187 = (_e88 - _e186);
                                let _e190 = (select(_e183, _e187, (_e187 < _e183)) - _e147);
                                let _e192 = select(_e190, _e143, (_e143 < _e190));
                                atomicStore((&shared_[3u]), (_e186 + _e147));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e147 + _e192));
                                phi_437_ = _e192;
                            } else {
                                if (_e147 == 0u) {
                                    let _e154 = (_e88 >> bitcast<u32>(((_e79.member_7 + 2u) & 31u)));
                                    let _e156 = select(_e79.member_8, _e154, (_e79.member_8 < _e154));
                                    let _e158 = select(_e156, 128u, (128u < _e156));
                                    let _e160 = select(_e158, _e143, (_e143 < _e158));
                                    let _e163 = atomicAdd((&control.member[(512u + _e81.member_1)]), _e160);
                                    let _e166 = (_e88 - select(_e163, _e88, (_e88 < _e163)));
                                    let _e168 = select(_e166, _e160, (_e160 < _e166));
                                    atomicStore((&shared_[3u]), _e163);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e168 < _e160)));
                                    phi_436_ = _e168;
                                } else {
                                    phi_436_ = 0u;
                                }
                                let _e175 = phi_436_;
                                phi_437_ = _e175;
                            }
                            let _e199 = phi_437_;
                            phi_438_ = _e199;
                        }
                        let _e223 = phi_438_;
                        phi_439_ = _e223;
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e225 = phi_439_;
                    phi_440_ = _e225;
                } else {
                    phi_440_ = 0u;
                }
                let _e227 = phi_440_;
                if (_e142 == 0u) {
                    if ((_e125 + _e227) == 0u) {
                        if (_e79.member_9 > 0u) {
                            let _e234 = atomicAdd((&control.member[(1024u + _e81.member_1)]), 1u);
                        }
                        phi_460_ = 1u;
                    } else {
                        phi_460_ = _e142;
                    }
                    let _e236 = phi_460_;
                    phi_461_ = _e236;
                } else {
                    phi_461_ = _e142;
                }
                let _e238 = phi_461_;
                atomicStore((&shared_[1u]), _e125);
                atomicStore((&shared_[2u]), _e227);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                phi_475_ = type_9(0u, 4u);
                loop {
                    let _e245 = phi_475_;
                    let _e248 = (_e245.member < _e245.member_1);
                    let _e261 = (bitcast<i32>(select(0u, 1u, _e248)) != 0i);
                    if _e261 {
                        atomicStore((&shared_[(18u + select(type_9().member_1, _e245.member, _e248))]), 0u);
                    }
                    continue;
                    continuing {
                        phi_475_ = type_9(select(_e245.member, (_e245.member + 1u), _e248), select(_e245.member_1, _e245.member_1, _e248));
                        break if !(_e261);
                    }
                }
                state[0u] = _e238;
            }
            let _e267 = workgroupUniformLoad((&state[0u]));
            if (_e267 != 0u) {
                phi_1572_ = false;
            } else {
                let _e269 = (_e65 / 32u);
                let _e271 = atomicLoad((&shared_[1u]));
                let _e273 = atomicLoad((&shared_[2u]));
                if (_e269 < _e271) {
                    let _e296 = atomicLoad((&shared_[0u]));
                    let _e299 = (2u * ((_e296 - 1u) - _e269));
                    let _e301 = stack[_e299];
                    let _e304 = stack[(_e299 + 1u)];
                    phi_583_ = array<u32, 2>(_e301, _e304);
                } else {
                    if (_e269 < (_e271 + _e273)) {
                        let _e278 = atomicLoad((&shared_[3u]));
                        let _e281 = atomicLoad((&shared_[4u]));
                        let _e285 = (2u * (_e89 + (_e278 + ((_e269 - _e271) * _e281))));
                        let _e288 = atomicLoad((&nodes.member[(4u + _e285)]));
                        let _e291 = atomicLoad((&nodes.member[(_e285 + 5u)]));
                        phi_582_ = array<u32, 2>(_e288, _e291);
                    } else {
                        phi_582_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e294 = phi_582_;
                    phi_583_ = _e294;
                }
                let _e307 = phi_583_;
                let _e308 = (_e65 / 32u);
                let _e309 = (_e65 % 32u);
                let _e311 = (_e307[0] != 4294967295u);
                let _e313 = select(134217728u, _e307[0], _e311);
                let _e315 = select(0u, _e307[1], _e311);
                let _e317 = (_e313 >> bitcast<u32>(27u));
                let _e318 = (_e313 & 134217727u);
                let _e319 = (_e317 - 1u);
                let _e321 = ((_e318 * 32u) + _e309);
                let _e322 = (_e315 * 32u);
                let _e326 = params.member.member_2.member.member;
                let _e327 = (_e326 == 0u);
                let _e333 = params.member.member.member[select(1u, 2u, _e327)];
                let _e334 = (5u * _e319);
                let _e335 = (_e333 > 0u);
                let _e336 = (_e334 < 32u);
                let _e348 = select(select(u32(), select(u32(), (((_e333 - 1u) >> bitcast<u32>((_e334 & 31u))) + 1u), _e336), _e335), select(0u, 1u, (_e333 > 0u)), select(true, select(true, false, _e336), _e335));
                let _e349 = (_e315 * 32u);
                let _e352 = (select(_e349, _e348, (_e349 < _e348)) - _e349);
                let _e358 = select(((1u << bitcast<u32>((_e352 & 31u))) - 1u), 4294967295u, (_e352 >= 32u));
                let _e363 = params.member.member_2.member_1[_e319][1u];
                let _e364 = (_e363 + _e322);
                if _e311 {
                    if (((_e358 >> bitcast<u32>((_e309 & 31u))) & 1u) == 1u) {
                        let _e372 = boxes.member[(_e364 + _e309)];
                        let _e389 = params.member.member_2.member_1[_e317][0u];
                        let _e392 = boxes.member[(_e389 + _e318)];
                        if ((((((_e372.member.x <= _e392.member_1.y) && (_e392.member.x <= _e372.member_1.y)) && (_e372.member.y <= _e392.member_2.x)) && (_e392.member.y <= _e372.member_2.x)) && (_e372.member_1.x <= _e392.member_2.y)) && (_e392.member_1.x <= _e372.member_2.y)) {
                            let _e421 = atomicOr((&shared_[(18u + _e308)]), (1u << bitcast<u32>((_e309 & 31u))));
                        }
                    }
                    let _e425 = params.member.member.member[select(1u, 0u, _e327)];
                    let _e426 = (5u * _e319);
                    let _e427 = (_e425 > 0u);
                    let _e428 = (_e426 < 32u);
                    if (_e321 < select(select(u32(), select(u32(), (((_e425 - 1u) >> bitcast<u32>((_e426 & 31u))) + 1u), _e428), _e427), select(0u, 1u, (_e425 > 0u)), select(true, select(true, false, _e428), _e427))) {
                        let _e446 = params.member.member_2.member_1[_e319][0u];
                        let _e449 = boxes.member[(_e446 + _e321)];
                        phi_832_ = type_21(array<f32, 3>(_e449.member.x, _e449.member.y, _e449.member_1.x), array<f32, 3>(_e449.member_1.y, _e449.member_2.x, _e449.member_2.y));
                        phi_833_ = true;
                    } else {
                        phi_832_ = type_21(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_833_ = false;
                    }
                    let _e466 = phi_832_;
                    let _e468 = phi_833_;
                    phi_834_ = _e466;
                    phi_835_ = _e468;
                } else {
                    phi_834_ = type_21(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    phi_835_ = false;
                }
                let _e470 = phi_834_;
                let _e472 = phi_835_;
                workgroupBarrier();
                if _e472 {
                    let _e476 = params.member.member_2.member.member;
                    let _e483 = select(4294967295u, (4294967295u << bitcast<u32>((_e309 & 31u))), select(false, (_e318 == _e315), (_e476 == 1u)));
                    let _e488 = params.member.member_2.member_1[_e317][1u];
                    let _e491 = boxes.member[(_e488 + _e315)];
                    if ((((((_e470.member[0] <= _e491.member_1.y) && (_e491.member.x <= _e470.member_1[0])) && (_e470.member[1] <= _e491.member_2.x)) && (_e491.member.y <= _e470.member_1[1])) && (_e470.member[2] <= _e491.member_2.y)) && (_e491.member_1.x <= _e470.member_1[2])) {
                        let _e529 = atomicLoad((&shared_[(18u + _e308)]));
                        phi_913_ = type_9(0u, 32u);
                        phi_916_ = 0u;
                        phi_918_ = (_e529 & _e483);
                        loop {
                            let _e532 = phi_913_;
                            let _e534 = phi_916_;
                            let _e536 = phi_918_;
                            local_2 = _e534;
                            let _e539 = (_e532.member < _e532.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e539)) != 0i) {
                                if (_e536 == 0u) {
                                    phi_998_ = u32();
                                    phi_999_ = u32();
                                    phi_1000_ = false;
                                } else {
                                    let _e554 = select(firstTrailingBit(_e536), 32u, (_e536 == 0u));
                                    let _e559 = boxes.member[(_e364 + _e554)];
                                    phi_998_ = select(_e534, (_e534 | (1u << bitcast<u32>((_e554 & 31u)))), ((((((_e470.member[0] <= _e559.member_1.y) && (_e559.member.x <= _e470.member_1[0])) && (_e470.member[1] <= _e559.member_2.x)) && (_e559.member.y <= _e470.member_1[1])) && (_e470.member[2] <= _e559.member_2.y)) && (_e559.member_1.x <= _e470.member_1[2])));
                                    phi_999_ = (_e536 & (_e536 - 1u));
                                    phi_1000_ = true;
                                }
                                let _e601 = phi_998_;
                                let _e603 = phi_999_;
                                let _e605 = phi_1000_;
                                phi_917_ = _e601;
                                phi_919_ = _e603;
                                phi_1001_ = _e605;
                            } else {
                                phi_917_ = u32();
                                phi_919_ = u32();
                                phi_1001_ = false;
                            }
                            let _e607 = phi_917_;
                            let _e609 = phi_919_;
                            let _e611 = phi_1001_;
                            continue;
                            continuing {
                                phi_913_ = type_9(select(_e532.member, (_e532.member + 1u), _e539), select(_e532.member_1, _e532.member_1, _e539));
                                phi_916_ = _e607;
                                phi_918_ = _e609;
                                break if !(_e611);
                            }
                        }
                        let _e1302 = local_2;
                        phi_1002_ = _e1302;
                    } else {
                        phi_1002_ = 0u;
                    }
                    let _e614 = phi_1002_;
                    let _e618 = params.member.member_2.member.member_4;
                    phi_1014_ = _e614;
                    phi_1015_ = select(0u, ((_e358 & _e483) & ~(_e614)), (_e618 > 0u));
                } else {
                    phi_1014_ = 0u;
                    phi_1015_ = 0u;
                }
                let _e625 = phi_1014_;
                let _e627 = phi_1015_;
                if (_e79.member_11 == 1u) {
                    let _e682 = countOneBits(_e625);
                    if (select(2u, 1u, (_e319 > 1u)) == 1u) {
                        phi_1037_ = array<u32, 3>(_e682, 0u, countOneBits(_e627));
                    } else {
                        phi_1037_ = array<u32, 3>(0u, _e682, (countOneBits(_e627) + _e682));
                    }
                    let _e692 = phi_1037_;
                    let _e693 = (_e79.member_4 == 0u);
                    let _e701 = select(_e692[2], 0u, _e693);
                    let _e704 = (select(_e692[0], _e692[0], _e693) | (select(_e692[1], _e692[1], _e693) << bitcast<u32>(16i)));
                    sums[_e65] = _e704;
                    phi_1052_ = type_9(0u, 7u);
                    phi_1055_ = 0u;
                    phi_1057_ = 1u;
                    phi_1059_ = _e704;
                    phi_1056_ = 128u;
                    loop {
                        let _e707 = phi_1052_;
                        let _e709 = phi_1055_;
                        let _e711 = phi_1057_;
                        let _e713 = phi_1059_;
                        let _e715 = phi_1056_;
                        local = _e713;
                        let _e718 = (_e707.member < _e707.member_1);
                        let _e729 = (bitcast<i32>(select(0u, 1u, _e718)) != 0i);
                        if _e729 {
                            workgroupBarrier();
                            if (_e65 >= _e711) {
                                let _e734 = sums[((_e709 + _e65) - _e711)];
                                phi_1098_ = (_e713 + _e734);
                            } else {
                                phi_1098_ = _e713;
                            }
                            let _e737 = phi_1098_;
                            sums[(_e715 + _e65)] = _e737;
                            phi_1058_ = (_e711 * 2u);
                            phi_1060_ = _e737;
                        } else {
                            phi_1058_ = u32();
                            phi_1060_ = u32();
                        }
                        let _e742 = phi_1058_;
                        let _e744 = phi_1060_;
                        continue;
                        continuing {
                            phi_1052_ = type_9(select(_e707.member, (_e707.member + 1u), _e718), select(_e707.member_1, _e707.member_1, _e718));
                            phi_1055_ = _e715;
                            phi_1057_ = _e742;
                            phi_1059_ = _e744;
                            phi_1056_ = _e709;
                            break if !(_e729);
                        }
                    }
                    workgroupBarrier();
                    let _e747 = local;
                    let _e748 = (_e747 - _e704);
                    if (_e65 == 0u) {
                        let _e751 = sums[255u];
                        atomicStore((&shared_[6u]), (_e751 & 65535u));
                        atomicStore((&shared_[7u]), (_e751 >> bitcast<u32>(16i)));
                    }
                    if (_e79.member_4 > 0u) {
                        sums[_e65] = _e701;
                        phi_1126_ = type_9(0u, 7u);
                        phi_1129_ = 0u;
                        phi_1131_ = 1u;
                        phi_1133_ = _e701;
                        phi_1130_ = 128u;
                        loop {
                            let _e761 = phi_1126_;
                            let _e763 = phi_1129_;
                            let _e765 = phi_1131_;
                            let _e767 = phi_1133_;
                            let _e769 = phi_1130_;
                            local_1 = _e767;
                            let _e772 = (_e761.member < _e761.member_1);
                            let _e783 = (bitcast<i32>(select(0u, 1u, _e772)) != 0i);
                            if _e783 {
                                workgroupBarrier();
                                if (_e65 >= _e765) {
                                    let _e788 = sums[((_e763 + _e65) - _e765)];
                                    phi_1172_ = (_e767 + _e788);
                                } else {
                                    phi_1172_ = _e767;
                                }
                                let _e791 = phi_1172_;
                                sums[(_e769 + _e65)] = _e791;
                                phi_1132_ = (_e765 * 2u);
                                phi_1134_ = _e791;
                            } else {
                                phi_1132_ = u32();
                                phi_1134_ = u32();
                            }
                            let _e796 = phi_1132_;
                            let _e798 = phi_1134_;
                            continue;
                            continuing {
                                phi_1126_ = type_9(select(_e761.member, (_e761.member + 1u), _e772), select(_e761.member_1, _e761.member_1, _e772));
                                phi_1129_ = _e769;
                                phi_1131_ = _e796;
                                phi_1133_ = _e798;
                                phi_1130_ = _e763;
                                break if !(_e783);
                            }
                        }
                        workgroupBarrier();
                        let _e801 = local_1;
                        if (_e65 == 0u) {
                            let _e805 = sums[255u];
                            atomicStore((&shared_[8u]), _e805);
                        }
                        phi_1187_ = (_e801 - _e701);
                    } else {
                        phi_1187_ = 0u;
                    }
                    let _e808 = phi_1187_;
                    phi_1272_ = array<u32, 2>(select((_e748 >> bitcast<u32>(16i)), (_e748 & 65535u), (select(2u, 1u, (_e319 > 1u)) == 1u)), _e808);
                } else {
                    let _e631 = countOneBits(_e625);
                    if (select(2u, 1u, (_e319 > 1u)) == 1u) {
                        phi_1217_ = array<u32, 3>(_e631, 0u, countOneBits(_e627));
                    } else {
                        phi_1217_ = array<u32, 3>(0u, _e631, (countOneBits(_e627) + _e631));
                    }
                    let _e641 = phi_1217_;
                    let _e642 = (_e79.member_4 == 0u);
                    let _e645 = select(_e641[0], _e641[0], _e642);
                    let _e648 = select(_e641[1], _e641[1], _e642);
                    let _e650 = select(_e641[2], 0u, _e642);
                    if (_e645 > 0u) {
                        let _e653 = atomicAdd((&shared_[6u]), _e645);
                        phi_1235_ = array<u32, 3>(_e653, 0u, 0u);
                    } else {
                        phi_1235_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e656 = phi_1235_;
                    if (_e648 > 0u) {
                        let _e659 = atomicAdd((&shared_[7u]), _e648);
                        phi_1246_ = array<u32, 3>(_e656[0], _e659, _e656[2]);
                    } else {
                        phi_1246_ = _e656;
                    }
                    let _e664 = phi_1246_;
                    if (_e650 > 0u) {
                        let _e667 = atomicAdd((&shared_[8u]), _e650);
                        phi_1257_ = array<u32, 3>(_e664[0], _e664[1], _e667);
                    } else {
                        phi_1257_ = _e664;
                    }
                    let _e672 = phi_1257_;
                    phi_1272_ = array<u32, 2>(select(_e672[1], _e672[0], (select(2u, 1u, (_e319 > 1u)) == 1u)), _e672[2]);
                }
                let _e818 = phi_1272_;
                workgroupBarrier();
                if (_e65 == 0u) {
                    let _e821 = atomicLoad((&shared_[6u]));
                    let _e823 = atomicLoad((&shared_[7u]));
                    let _e825 = atomicLoad((&shared_[8u]));
                    let _e827 = atomicLoad((&shared_[1u]));
                    let _e829 = atomicLoad((&shared_[2u]));
                    let _e831 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e831 + 1u));
                    let _e835 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e835 + _e827) + _e829));
                    let _e840 = atomicLoad((&shared_[0u]));
                    let _e841 = (_e840 - _e827);
                    let _e843 = (_e79.member_10 - _e841);
                    let _e845 = select(_e821, _e843, (_e843 < _e821));
                    atomicStore((&shared_[9u]), _e841);
                    atomicStore((&shared_[10u]), _e845);
                    atomicStore((&shared_[0u]), (_e841 + _e845));
                    if (_e821 > _e845) {
                        let _e851 = (_e821 - _e845);
                        if (_e79.member_13 == 0u) {
                        } else {
                            let _e855 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e858 = atomicAdd((&control.member[(_e81.member_1 + 1u)]), _e851);
                        let _e861 = atomicMax((&nodes.member[0u]), (_e858 + _e851));
                        if ((_e858 + _e851) < _e858) {
                            let _e865 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e858);
                    }
                    if (_e823 > 0u) {
                        let _e869 = atomicAdd((&pairs.member[0u]), _e823);
                        if ((_e869 + _e823) < _e869) {
                            let _e873 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e869);
                    }
                    if (_e825 > 0u) {
                        let _e877 = atomicAdd((&control.member[1537u]), _e825);
                        if ((_e877 + _e825) < _e877) {
                            let _e881 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e877);
                    }
                }
                workgroupBarrier();
                phi_1406_ = type_9(0u, 32u);
                phi_1409_ = _e818[1];
                phi_1411_ = _e818[0];
                phi_1413_ = (_e625 | _e627);
                loop {
                    let _e889 = phi_1406_;
                    let _e891 = phi_1409_;
                    let _e893 = phi_1411_;
                    let _e895 = phi_1413_;
                    let _e898 = (_e889.member < _e889.member_1);
                    if (bitcast<i32>(select(0u, 1u, _e898)) != 0i) {
                        if (_e895 == 0u) {
                            phi_1567_ = u32();
                            phi_1568_ = u32();
                            phi_1569_ = u32();
                            phi_1570_ = false;
                        } else {
                            let _e913 = select(firstTrailingBit(_e895), 32u, (_e895 == 0u));
                            let _e916 = (_e322 + _e913);
                            let _e919 = ((_e319 << bitcast<u32>(27u)) | _e321);
                            let _e925 = select(select(2u, 1u, (_e319 > 1u)), 3u, (((_e627 >> bitcast<u32>((_e913 & 31u))) & 1u) == 1u));
                            if (_e925 == 1u) {
                                let _e958 = atomicLoad((&shared_[10u]));
                                if (_e893 < _e958) {
                                    let _e974 = atomicLoad((&shared_[9u]));
                                    let _e976 = (2u * (_e974 + _e893));
                                    stack[_e976] = _e919;
                                    stack[(_e976 + 1u)] = _e916;
                                } else {
                                    let _e961 = atomicLoad((&shared_[11u]));
                                    let _e963 = ((_e961 + _e893) - _e958);
                                    if (_e963 < _e79.member_3) {
                                        let _e966 = (_e91 + _e963);
                                        if (_e966 < 4294967295u) {
                                            let _e968 = (2u * _e966);
                                            atomicStore((&nodes.member[(4u + _e968)]), _e919);
                                            atomicStore((&nodes.member[(_e968 + 5u)]), _e916);
                                        }
                                    }
                                }
                            } else {
                                if (_e925 == 0u) {
                                } else {
                                    if (_e925 == 2u) {
                                        let _e931 = params.member.member_1;
                                        let _e934 = atomicLoad((&shared_[12u]));
                                        let _e935 = (_e934 + _e893);
                                        if (_e935 < _e931.member_3) {
                                            let _e937 = (2u * _e935);
                                            atomicStore((&pairs.member[(4u + _e937)]), (_e919 & 134217727u));
                                            atomicStore((&pairs.member[(_e937 + 5u)]), _e916);
                                        }
                                    }
                                    if (_e79.member_4 > 0u) {
                                        let _e945 = atomicLoad((&shared_[13u]));
                                        let _e946 = (_e945 + _e891);
                                        if (_e946 < _e79.member_4) {
                                            let _e953 = (2u * ((_e79.member_5 * _e79.member_4) + _e946));
                                            front.member[_e953] = _e919;
                                            front.member[(_e953 + 1u)] = _e916;
                                        }
                                    }
                                }
                            }
                            phi_1567_ = (_e891 + select(0u, 1u, (_e925 != 1u)));
                            phi_1568_ = (_e893 + select(0u, 1u, (_e925 != 3u)));
                            phi_1569_ = (_e895 & (_e895 - 1u));
                            phi_1570_ = true;
                        }
                        let _e987 = phi_1567_;
                        let _e989 = phi_1568_;
                        let _e991 = phi_1569_;
                        let _e993 = phi_1570_;
                        phi_1410_ = _e987;
                        phi_1412_ = _e989;
                        phi_1414_ = _e991;
                        phi_1571_ = _e993;
                    } else {
                        phi_1410_ = u32();
                        phi_1412_ = u32();
                        phi_1414_ = u32();
                        phi_1571_ = false;
                    }
                    let _e995 = phi_1410_;
                    let _e997 = phi_1412_;
                    let _e999 = phi_1414_;
                    let _e1001 = phi_1571_;
                    continue;
                    continuing {
                        phi_1406_ = type_9(select(_e889.member, (_e889.member + 1u), _e898), select(_e889.member_1, _e889.member_1, _e898));
                        phi_1409_ = _e995;
                        phi_1411_ = _e997;
                        phi_1413_ = _e999;
                        break if !(_e1001);
                    }
                }
                phi_1572_ = true;
            }
            let _e1004 = phi_1572_;
            phi_1573_ = _e1004;
        } else {
            phi_1573_ = false;
        }
        let _e1006 = phi_1573_;
        continue;
        continuing {
            phi_215_ = type_9(select(_e100.member, (_e100.member + 1u), _e103), select(_e100.member_1, _e100.member_1, _e103));
            break if !(_e1006);
        }
    }
    if (_e65 == 0u) {
        if (_e79.member_6 == 0u) {
            let _e1021 = atomicLoad((&shared_[5u]));
            phi_1601_ = (select(0u, ((((_e88 - 1u) - _e76) >> bitcast<u32>((_e79.member_7 & 31u))) + 1u), (_e76 < _e88)) - _e1021);
        } else {
            phi_1601_ = 0u;
        }
        let _e1024 = phi_1601_;
        atomicStore((&shared_[14u]), _e1024);
        let _e1027 = atomicLoad((&shared_[0u]));
        let _e1028 = (_e1027 + _e1024);
        if (_e79.member_6 == 2u) {
            let _e1055 = (((_e88 + (1u << bitcast<u32>((_e79.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e79.member_7 & 31u)));
            let _e1056 = (_e76 * _e1055);
            let _e1059 = (_e88 - select(_e1056, _e88, (_e88 < _e1056)));
            let _e1068 = ((1540u + (2u * (1u << bitcast<u32>((_e79.member_7 & 31u))))) + (2u * _e76));
            let _e1070 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e1068]), _e1070);
            let _e1074 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e1068 + 1u)]), (select(_e1055, _e1059, (_e1059 < _e1055)) - _e1074));
        } else {
            if (_e1028 > 0u) {
                if (_e79.member_13 == 0u) {
                } else {
                    let _e1035 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e1038 = atomicAdd((&control.member[(_e81.member_1 + 1u)]), _e1028);
                let _e1041 = atomicMax((&nodes.member[0u]), (_e1038 + _e1028));
                if ((_e1038 + _e1028) < _e1038) {
                    let _e1045 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e1038);
            }
        }
        let _e1080 = atomicLoad((&shared_[15u]));
        let _e1082 = atomicAdd((&control.member[(1540u + (2u * _e76))]), _e1080);
        let _e1086 = atomicLoad((&shared_[16u]));
        let _e1088 = atomicAdd((&control.member[((2u * _e76) + 1541u)]), _e1086);
    }
    workgroupBarrier();
    let _e1090 = atomicLoad((&shared_[0u]));
    let _e1092 = atomicLoad((&shared_[17u]));
    let _e1094 = atomicLoad((&shared_[14u]));
    phi_1721_ = type_9(0u, 8u);
    loop {
        let _e1096 = phi_1721_;
        let _e1099 = (_e1096.member < _e1096.member_1);
        let _e1112 = (bitcast<i32>(select(0u, 1u, _e1099)) != 0i);
        if _e1112 {
            let _e1114 = ((select(type_9().member_1, _e1096.member, _e1099) * 128u) + _e65);
            if (_e1114 < _e1090) {
                let _e1118 = stack[(2u * _e1114)];
                let _e1122 = stack[((2u * _e1114) + 1u)];
                if (_e79.member_6 == 2u) {
                    let _e1154 = ((((((1540u + (2u * (1u << bitcast<u32>((_e79.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e79.member_7 & 31u))))) + (1u << bitcast<u32>((_e79.member_7 & 31u)))) + 1u) + (_e76 * 2048u)) + (2u * _e1114));
                    atomicStore((&control.member[_e1154]), _e1118);
                    atomicStore((&control.member[(_e1154 + 1u)]), _e1122);
                } else {
                    let _e1125 = (_e1092 + _e1114);
                    if (_e1125 < _e79.member_3) {
                        let _e1128 = (_e91 + _e1125);
                        if (_e1128 < 4294967295u) {
                            let _e1130 = (2u * _e1128);
                            atomicStore((&nodes.member[(4u + _e1130)]), _e1118);
                            atomicStore((&nodes.member[(_e1130 + 5u)]), _e1122);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1721_ = type_9(select(_e1096.member, (_e1096.member + 1u), _e1099), select(_e1096.member_1, _e1096.member_1, _e1099));
            break if !(_e1112);
        }
    }
    let _e1160 = atomicLoad((&shared_[5u]));
    let _e1161 = (_e1094 / 128u);
    phi_1839_ = type_9(0u, select(_e1161, (_e1161 + 1u), ((_e1094 % 128u) > 0u)));
    loop {
        let _e1168 = phi_1839_;
        let _e1171 = (_e1168.member < _e1168.member_1);
        let _e1184 = (bitcast<i32>(select(0u, 1u, _e1171)) != 0i);
        if _e1184 {
            let _e1186 = ((select(type_9().member_1, _e1168.member, _e1171) * 128u) + _e65);
            if (_e1186 < _e1094) {
                let _e1195 = (2u * ((_e89 + _e76) + ((_e1160 + _e1186) << bitcast<u32>((_e79.member_7 & 31u)))));
                let _e1198 = atomicLoad((&nodes.member[(4u + _e1195)]));
                let _e1201 = atomicLoad((&nodes.member[(_e1195 + 5u)]));
                let _e1203 = ((_e1092 + _e1090) + _e1186);
                if (_e1203 < _e79.member_3) {
                    let _e1206 = (_e91 + _e1203);
                    if (_e1206 < 4294967295u) {
                        let _e1208 = (2u * _e1206);
                        atomicStore((&nodes.member[(4u + _e1208)]), _e1198);
                        atomicStore((&nodes.member[(_e1208 + 5u)]), _e1201);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1839_ = type_9(select(_e1168.member, (_e1168.member + 1u), _e1171), select(_e1168.member_1, _e1168.member_1, _e1171));
            break if !(_e1184);
        }
    }
    if (_e79.member_6 == 1u) {
        if (_e1160 == 0u) {
            phi_1944_ = type_9(0u, _e88);
            loop {
                let _e1219 = phi_1944_;
                let _e1222 = (_e1219.member < _e1219.member_1);
                if (bitcast<i32>(select(0u, 1u, _e1222)) != 0i) {
                    let _e1236 = atomicAdd((&control.member[(512u + _e81.member_1)]), 1u);
                    if (_e1236 >= _e88) {
                        phi_2060_ = false;
                    } else {
                        let _e1239 = (2u * (_e89 + _e1236));
                        let _e1242 = atomicLoad((&nodes.member[(4u + _e1239)]));
                        let _e1245 = atomicLoad((&nodes.member[(_e1239 + 5u)]));
                        if (_e79.member_13 == 0u) {
                        } else {
                            let _e1249 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1252 = atomicAdd((&control.member[(_e81.member_1 + 1u)]), 1u);
                        let _e1255 = atomicMax((&nodes.member[0u]), (_e1252 + 1u));
                        if ((_e1252 + 1u) < _e1252) {
                            let _e1259 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1252 < _e79.member_3) {
                            let _e1262 = (_e91 + _e1252);
                            if (_e1262 < 4294967295u) {
                                let _e1264 = (2u * _e1262);
                                atomicStore((&nodes.member[(4u + _e1264)]), _e1242);
                                atomicStore((&nodes.member[(_e1264 + 5u)]), _e1245);
                            }
                        }
                        phi_2060_ = true;
                    }
                    let _e1270 = phi_2060_;
                    phi_2061_ = _e1270;
                } else {
                    phi_2061_ = false;
                }
                let _e1272 = phi_2061_;
                continue;
                continuing {
                    phi_1944_ = type_9(select(_e1219.member, (_e1219.member + 1u), _e1222), select(_e1219.member_1, _e1219.member_1, _e1222));
                    break if !(_e1272);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn block_workers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
