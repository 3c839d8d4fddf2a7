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

struct type_23 {
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
    member: type_23,
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
    var phi_177_: u32;
    var phi_215_: type_9;
    var phi_216_: type_9;
    var phi_239_: type_9;
    var phi_263_: u32;
    var phi_294_: bool;
    var phi_298_: u32;
    var phi_299_: u32;
    var phi_300_: u32;
    var phi_398_: u32;
    var phi_403_: u32;
    var phi_408_: u32;
    var phi_421_: u32;
    var phi_427_: u32;
    var phi_436_: u32;
    var phi_365_: u32;
    var phi_371_: u32;
    var phi_377_: u32;
    var phi_437_: u32;
    var phi_328_: u32;
    var phi_334_: u32;
    var phi_438_: u32;
    var phi_439_: u32;
    var phi_440_: u32;
    var phi_460_: u32;
    var phi_461_: u32;
    var phi_475_: type_9;
    var phi_476_: type_9;
    var phi_499_: type_9;
    var phi_582_: array<u32, 2>;
    var phi_583_: array<u32, 2>;
    var phi_600_: array<u32, 2>;
    var phi_618_: array<u32, 2>;
    var phi_641_: u32;
    var phi_642_: bool;
    var phi_643_: u32;
    var phi_644_: bool;
    var phi_650_: u32;
    var phi_656_: u32;
    var phi_665_: u32;
    var phi_782_: u32;
    var phi_783_: bool;
    var phi_784_: u32;
    var phi_785_: bool;
    var phi_791_: u32;
    var phi_832_: type_21;
    var phi_833_: bool;
    var phi_834_: type_21;
    var phi_835_: bool;
    var phi_847_: bool;
    var phi_853_: u32;
    var phi_913_: type_9;
    var phi_916_: u32;
    var phi_918_: u32;
    var phi_914_: type_9;
    var phi_941_: type_9;
    var phi_997_: u32;
    var phi_998_: u32;
    var phi_999_: u32;
    var phi_1000_: bool;
    var phi_917_: u32;
    var phi_919_: u32;
    var phi_1001_: bool;
    var phi_1002_: u32;
    var phi_1013_: u32;
    var phi_1014_: u32;
    var phi_1015_: u32;
    var phi_1210_: u32;
    var phi_1217_: array<u32, 3>;
    var phi_1223_: array<u32, 3>;
    var phi_1235_: array<u32, 3>;
    var phi_1246_: array<u32, 3>;
    var phi_1257_: array<u32, 3>;
    var phi_1262_: u32;
    var phi_1269_: u32;
    var phi_1030_: u32;
    var phi_1037_: array<u32, 3>;
    var phi_1043_: array<u32, 3>;
    var phi_1052_: type_9;
    var phi_1055_: u32;
    var phi_1057_: u32;
    var phi_1059_: u32;
    var phi_1056_: u32;
    var phi_1053_: type_9;
    var phi_1082_: type_9;
    var phi_1098_: u32;
    var phi_1058_: u32;
    var phi_1060_: u32;
    var local: u32;
    var phi_1126_: type_9;
    var phi_1129_: u32;
    var phi_1131_: u32;
    var phi_1133_: u32;
    var phi_1130_: u32;
    var phi_1127_: type_9;
    var phi_1156_: type_9;
    var phi_1172_: u32;
    var phi_1132_: u32;
    var phi_1134_: u32;
    var local_1: u32;
    var phi_1187_: u32;
    var phi_1194_: u32;
    var phi_1199_: u32;
    var phi_1272_: array<u32, 2>;
    var phi_1316_: u32;
    var phi_1403_: u32;
    var phi_1406_: type_9;
    var phi_1409_: u32;
    var phi_1411_: u32;
    var phi_1413_: u32;
    var phi_1407_: type_9;
    var phi_1436_: type_9;
    var phi_1462_: u32;
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
    var phi_1596_: u32;
    var phi_1601_: u32;
    var phi_1627_: u32;
    var phi_1633_: u32;
    var phi_1721_: type_9;
    var phi_1722_: type_9;
    var phi_1745_: type_9;
    var phi_1836_: u32;
    var phi_1839_: type_9;
    var phi_1840_: type_9;
    var phi_1863_: type_9;
    var phi_1944_: type_9;
    var phi_1945_: type_9;
    var phi_1968_: type_9;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var local_2: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e65 = id_2;
    let _e66 = n_2;
    let _e67 = lane_2;
    let _e78 = ((_e65.y * _e66.x) + _e65.x);
    let _e81 = params.member.member_2.member;
    let _e83 = params.member.member_1;
    let _e86 = (_e83.member_1 % 2u);
    let _e88 = atomicLoad((&control.member[_e83.member_1]));
    if (_e81.member_3 < _e88) {
        phi_177_ = _e81.member_3;
    } else {
        phi_177_ = _e88;
    }
    let _e91 = phi_177_;
    let _e92 = (_e86 * _e81.member_3);
    let _e94 = ((1u - _e86) * _e81.member_3);
    if (_e67 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_215_ = type_9(0u, _e81.member_12);
    loop {
        let _e103 = phi_215_;
        if (_e103.member < _e103.member_1) {
            phi_216_ = type_9((_e103.member + 1u), _e103.member_1);
            phi_239_ = type_9(1u, _e103.member);
        } else {
            phi_216_ = _e103;
            phi_239_ = type_9(0u, type_9().member_1);
        }
        let _e115 = phi_216_;
        let _e117 = phi_239_;
        if (bitcast<i32>(_e117.member) != 0i) {
            if (_e67 == 0u) {
                let _e128 = atomicLoad((&shared_[0u]));
                if (4u < _e128) {
                    phi_263_ = 4u;
                } else {
                    phi_263_ = _e128;
                }
                let _e131 = phi_263_;
                if (_e81.member_9 > 0u) {
                    if (_e117.member_1 >= 16u) {
                        let _e136 = atomicLoad((&control.member[(1024u + _e83.member_1)]));
                        if (_e81.member_9 > 0u) {
                            phi_294_ = ((_e136 * 100u) >= (_e81.member_9 << bitcast<u32>((_e81.member_7 & 31u))));
                        } else {
                            phi_294_ = false;
                        }
                        let _e144 = phi_294_;
                        if _e144 {
                            phi_298_ = 2u;
                        } else {
                            phi_298_ = 0u;
                        }
                        let _e146 = phi_298_;
                        phi_299_ = _e146;
                    } else {
                        phi_299_ = 0u;
                    }
                    let _e148 = phi_299_;
                    phi_300_ = _e148;
                } else {
                    phi_300_ = 0u;
                }
                let _e150 = phi_300_;
                let _e151 = (4u - _e131);
                if (_e150 == 0u) {
                    if (_e151 > 0u) {
                        let _e155 = atomicLoad((&shared_[5u]));
                        if (_e81.member_6 == 0u) {
                            if (_e78 < _e91) {
                                phi_328_ = ((((_e91 - 1u) - _e78) >> bitcast<u32>((_e81.member_7 & 31u))) + 1u);
                            } else {
                                phi_328_ = 0u;
                            }
                            let _e224 = phi_328_;
                            let _e225 = (_e224 - _e155);
                            if (_e151 < _e225) {
                                phi_334_ = _e151;
                            } else {
                                phi_334_ = _e225;
                            }
                            let _e228 = phi_334_;
                            atomicStore((&shared_[3u]), (_e78 + (_e155 << bitcast<u32>((_e81.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e81.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e155 + _e228));
                            phi_438_ = _e228;
                        } else {
                            if (_e81.member_6 == 2u) {
                                let _e196 = (((_e91 + (1u << bitcast<u32>((_e81.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e81.member_7 & 31u)));
                                let _e197 = (_e78 * _e196);
                                if (_e91 < _e197) {
                                    phi_365_ = _e91;
                                } else {
                                    phi_365_ = _e197;
                                }
                                let _e200 = phi_365_;
                                let _e201 = (_e91 - _e200);
                                if (_e201 < _e196) {
                                    phi_371_ = _e201;
                                } else {
                                    phi_371_ = _e196;
                                }
                                let _e204 = phi_371_;
                                let _e205 = (_e204 - _e155);
                                if (_e151 < _e205) {
                                    phi_377_ = _e151;
                                } else {
                                    phi_377_ = _e205;
                                }
                                let _e208 = phi_377_;
                                atomicStore((&shared_[3u]), (_e200 + _e155));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e155 + _e208));
                                phi_437_ = _e208;
                            } else {
                                if (_e155 == 0u) {
                                    let _e162 = (_e91 >> bitcast<u32>(((_e81.member_7 + 2u) & 31u)));
                                    if (_e81.member_8 < _e162) {
                                        phi_398_ = _e162;
                                    } else {
                                        phi_398_ = _e81.member_8;
                                    }
                                    let _e165 = phi_398_;
                                    if (128u < _e165) {
                                        phi_403_ = 128u;
                                    } else {
                                        phi_403_ = _e165;
                                    }
                                    let _e168 = phi_403_;
                                    if (_e151 < _e168) {
                                        phi_408_ = _e151;
                                    } else {
                                        phi_408_ = _e168;
                                    }
                                    let _e171 = phi_408_;
                                    let _e174 = atomicAdd((&control.member[(512u + _e83.member_1)]), _e171);
                                    if (_e91 < _e174) {
                                        phi_421_ = _e91;
                                    } else {
                                        phi_421_ = _e174;
                                    }
                                    let _e177 = phi_421_;
                                    let _e178 = (_e91 - _e177);
                                    if (_e171 < _e178) {
                                        phi_427_ = _e171;
                                    } else {
                                        phi_427_ = _e178;
                                    }
                                    let _e181 = phi_427_;
                                    atomicStore((&shared_[3u]), _e174);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e181 < _e171)));
                                    phi_436_ = _e181;
                                } else {
                                    phi_436_ = 0u;
                                }
                                let _e188 = phi_436_;
                                phi_437_ = _e188;
                            }
                            let _e215 = phi_437_;
                            phi_438_ = _e215;
                        }
                        let _e241 = phi_438_;
                        phi_439_ = _e241;
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e243 = phi_439_;
                    phi_440_ = _e243;
                } else {
                    phi_440_ = 0u;
                }
                let _e245 = phi_440_;
                if (_e150 == 0u) {
                    if ((_e131 + _e245) == 0u) {
                        if (_e81.member_9 > 0u) {
                            let _e252 = atomicAdd((&control.member[(1024u + _e83.member_1)]), 1u);
                        }
                        phi_460_ = 1u;
                    } else {
                        phi_460_ = _e150;
                    }
                    let _e254 = phi_460_;
                    phi_461_ = _e254;
                } else {
                    phi_461_ = _e150;
                }
                let _e256 = phi_461_;
                atomicStore((&shared_[1u]), _e131);
                atomicStore((&shared_[2u]), _e245);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                phi_475_ = type_9(0u, 4u);
                loop {
                    let _e263 = phi_475_;
                    if (_e263.member < _e263.member_1) {
                        phi_476_ = type_9((_e263.member + 1u), _e263.member_1);
                        phi_499_ = type_9(1u, _e263.member);
                    } else {
                        phi_476_ = _e263;
                        phi_499_ = type_9(0u, type_9().member_1);
                    }
                    let _e275 = phi_476_;
                    let _e277 = phi_499_;
                    let _e281 = (bitcast<i32>(_e277.member) != 0i);
                    if _e281 {
                        atomicStore((&shared_[(18u + _e277.member_1)]), 0u);
                    }
                    continue;
                    continuing {
                        phi_475_ = _e275;
                        break if !(_e281);
                    }
                }
                state[0u] = _e256;
            }
            let _e287 = workgroupUniformLoad((&state[0u]));
            if (_e287 != 0u) {
                phi_1572_ = false;
            } else {
                let _e289 = (_e67 / 32u);
                let _e291 = atomicLoad((&shared_[1u]));
                let _e293 = atomicLoad((&shared_[2u]));
                if (_e289 < _e291) {
                    let _e316 = atomicLoad((&shared_[0u]));
                    let _e319 = (2u * ((_e316 - 1u) - _e289));
                    let _e321 = stack[_e319];
                    let _e324 = stack[(_e319 + 1u)];
                    phi_583_ = array<u32, 2>(_e321, _e324);
                } else {
                    if (_e289 < (_e291 + _e293)) {
                        let _e298 = atomicLoad((&shared_[3u]));
                        let _e301 = atomicLoad((&shared_[4u]));
                        let _e305 = (2u * (_e92 + (_e298 + ((_e289 - _e291) * _e301))));
                        let _e308 = atomicLoad((&nodes.member[(4u + _e305)]));
                        let _e311 = atomicLoad((&nodes.member[(_e305 + 5u)]));
                        phi_582_ = array<u32, 2>(_e308, _e311);
                    } else {
                        phi_582_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e314 = phi_582_;
                    phi_583_ = _e314;
                }
                let _e327 = phi_583_;
                let _e328 = (_e67 / 32u);
                let _e329 = (_e67 % 32u);
                let _e331 = (_e327[0] != 4294967295u);
                if _e331 {
                    phi_600_ = _e327;
                } else {
                    phi_600_ = array<u32, 2>(134217728u, 0u);
                }
                let _e333 = phi_600_;
                let _e337 = (_e333[0] >> bitcast<u32>(27u));
                let _e338 = (_e333[0] & 134217727u);
                let _e339 = (_e337 - 1u);
                let _e341 = ((_e338 * 32u) + _e329);
                let _e342 = (_e333[1] * 32u);
                let _e346 = params.member.member_2.member.member;
                if (_e346 == 0u) {
                    phi_618_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_618_ = array<u32, 2>(1u, 1u);
                }
                let _e349 = phi_618_;
                let _e355 = params.member.member.member[_e349[1]];
                let _e356 = (5u * _e339);
                if (_e355 > 0u) {
                    if (_e356 < 32u) {
                        phi_641_ = (((_e355 - 1u) >> bitcast<u32>((_e356 & 31u))) + 1u);
                        phi_642_ = false;
                    } else {
                        phi_641_ = u32();
                        phi_642_ = true;
                    }
                    let _e365 = phi_641_;
                    let _e367 = phi_642_;
                    phi_643_ = _e365;
                    phi_644_ = _e367;
                } else {
                    phi_643_ = u32();
                    phi_644_ = true;
                }
                let _e369 = phi_643_;
                let _e371 = phi_644_;
                if _e371 {
                    phi_650_ = select(0u, 1u, (_e355 > 0u));
                } else {
                    phi_650_ = _e369;
                }
                let _e375 = phi_650_;
                let _e376 = (_e333[1] * 32u);
                if (_e376 < _e375) {
                    phi_656_ = _e375;
                } else {
                    phi_656_ = _e376;
                }
                let _e379 = phi_656_;
                let _e380 = (_e379 - _e376);
                if (_e380 >= 32u) {
                    phi_665_ = 4294967295u;
                } else {
                    phi_665_ = ((1u << bitcast<u32>((_e380 & 31u))) - 1u);
                }
                let _e387 = phi_665_;
                let _e392 = params.member.member_2.member_1[_e339][1u];
                let _e393 = (_e392 + _e342);
                if _e331 {
                    if (((_e387 >> bitcast<u32>((_e329 & 31u))) & 1u) == 1u) {
                        let _e401 = boxes.member[(_e393 + _e329)];
                        let _e418 = params.member.member_2.member_1[_e337][0u];
                        let _e421 = boxes.member[(_e418 + _e338)];
                        if ((((((_e401.member.x <= _e421.member_1.y) && (_e421.member.x <= _e401.member_1.y)) && (_e401.member.y <= _e421.member_2.x)) && (_e421.member.y <= _e401.member_2.x)) && (_e401.member_1.x <= _e421.member_2.y)) && (_e421.member_1.x <= _e401.member_2.y)) {
                            let _e450 = atomicOr((&shared_[(18u + _e328)]), (1u << bitcast<u32>((_e329 & 31u))));
                        }
                    }
                    let _e454 = params.member.member.member[_e349[0]];
                    let _e455 = (5u * _e339);
                    if (_e454 > 0u) {
                        if (_e455 < 32u) {
                            phi_782_ = (((_e454 - 1u) >> bitcast<u32>((_e455 & 31u))) + 1u);
                            phi_783_ = false;
                        } else {
                            phi_782_ = u32();
                            phi_783_ = true;
                        }
                        let _e464 = phi_782_;
                        let _e466 = phi_783_;
                        phi_784_ = _e464;
                        phi_785_ = _e466;
                    } else {
                        phi_784_ = u32();
                        phi_785_ = true;
                    }
                    let _e468 = phi_784_;
                    let _e470 = phi_785_;
                    if _e470 {
                        phi_791_ = select(0u, 1u, (_e454 > 0u));
                    } else {
                        phi_791_ = _e468;
                    }
                    let _e474 = phi_791_;
                    if (_e341 < _e474) {
                        let _e480 = params.member.member_2.member_1[_e339][0u];
                        let _e483 = boxes.member[(_e480 + _e341)];
                        phi_832_ = type_21(array<f32, 3>(_e483.member.x, _e483.member.y, _e483.member_1.x), array<f32, 3>(_e483.member_1.y, _e483.member_2.x, _e483.member_2.y));
                        phi_833_ = true;
                    } else {
                        phi_832_ = type_21(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_833_ = false;
                    }
                    let _e500 = phi_832_;
                    let _e502 = phi_833_;
                    phi_834_ = _e500;
                    phi_835_ = _e502;
                } else {
                    phi_834_ = type_21(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    phi_835_ = false;
                }
                let _e504 = phi_834_;
                let _e506 = phi_835_;
                workgroupBarrier();
                if _e506 {
                    let _e510 = params.member.member_2.member.member;
                    if (_e510 == 1u) {
                        phi_847_ = (_e338 == _e333[1]);
                    } else {
                        phi_847_ = false;
                    }
                    let _e514 = phi_847_;
                    if _e514 {
                        phi_853_ = (4294967295u << bitcast<u32>((_e329 & 31u)));
                    } else {
                        phi_853_ = 4294967295u;
                    }
                    let _e519 = phi_853_;
                    let _e524 = params.member.member_2.member_1[_e337][1u];
                    let _e527 = boxes.member[(_e524 + _e333[1])];
                    if ((((((_e504.member[0] <= _e527.member_1.y) && (_e527.member.x <= _e504.member_1[0])) && (_e504.member[1] <= _e527.member_2.x)) && (_e527.member.y <= _e504.member_1[1])) && (_e504.member[2] <= _e527.member_2.y)) && (_e527.member_1.x <= _e504.member_1[2])) {
                        let _e565 = atomicLoad((&shared_[(18u + _e328)]));
                        phi_913_ = type_9(0u, 32u);
                        phi_916_ = 0u;
                        phi_918_ = (_e565 & _e519);
                        loop {
                            let _e568 = phi_913_;
                            let _e570 = phi_916_;
                            let _e572 = phi_918_;
                            local_2 = _e570;
                            if (_e568.member < _e568.member_1) {
                                phi_914_ = type_9((_e568.member + 1u), _e568.member_1);
                                phi_941_ = type_9(1u, _e568.member);
                            } else {
                                phi_914_ = _e568;
                                phi_941_ = type_9(0u, type_9().member_1);
                            }
                            let _e584 = phi_914_;
                            let _e586 = phi_941_;
                            if (bitcast<i32>(_e586.member) != 0i) {
                                if (_e572 == 0u) {
                                    phi_998_ = u32();
                                    phi_999_ = u32();
                                    phi_1000_ = false;
                                } else {
                                    let _e593 = select(firstTrailingBit(_e572), 32u, (_e572 == 0u));
                                    let _e598 = boxes.member[(_e393 + _e593)];
                                    if ((((((_e504.member[0] <= _e598.member_1.y) && (_e598.member.x <= _e504.member_1[0])) && (_e504.member[1] <= _e598.member_2.x)) && (_e598.member.y <= _e504.member_1[1])) && (_e504.member[2] <= _e598.member_2.y)) && (_e598.member_1.x <= _e504.member_1[2])) {
                                        phi_997_ = (_e570 | (1u << bitcast<u32>((_e593 & 31u))));
                                    } else {
                                        phi_997_ = _e570;
                                    }
                                    let _e639 = phi_997_;
                                    phi_998_ = _e639;
                                    phi_999_ = (_e572 & (_e572 - 1u));
                                    phi_1000_ = true;
                                }
                                let _e641 = phi_998_;
                                let _e643 = phi_999_;
                                let _e645 = phi_1000_;
                                phi_917_ = _e641;
                                phi_919_ = _e643;
                                phi_1001_ = _e645;
                            } else {
                                phi_917_ = u32();
                                phi_919_ = u32();
                                phi_1001_ = false;
                            }
                            let _e647 = phi_917_;
                            let _e649 = phi_919_;
                            let _e651 = phi_1001_;
                            continue;
                            continuing {
                                phi_913_ = _e584;
                                phi_916_ = _e647;
                                phi_918_ = _e649;
                                break if !(_e651);
                            }
                        }
                        let _e1413 = local_2;
                        phi_1002_ = _e1413;
                    } else {
                        phi_1002_ = 0u;
                    }
                    let _e654 = phi_1002_;
                    let _e658 = params.member.member_2.member.member_4;
                    if (_e658 > 0u) {
                        phi_1013_ = ((_e387 & _e519) & ~(_e654));
                    } else {
                        phi_1013_ = 0u;
                    }
                    let _e664 = phi_1013_;
                    phi_1014_ = _e654;
                    phi_1015_ = _e664;
                } else {
                    phi_1014_ = 0u;
                    phi_1015_ = 0u;
                }
                let _e666 = phi_1014_;
                let _e668 = phi_1015_;
                if (_e81.member_11 == 1u) {
                    let _e729 = countOneBits(_e666);
                    if (_e339 > 1u) {
                        phi_1030_ = 1u;
                    } else {
                        phi_1030_ = 2u;
                    }
                    let _e735 = phi_1030_;
                    if (_e735 == 1u) {
                        phi_1037_ = array<u32, 3>(_e729, 0u, countOneBits(_e668));
                    } else {
                        phi_1037_ = array<u32, 3>(0u, _e729, (countOneBits(_e668) + _e729));
                    }
                    let _e740 = phi_1037_;
                    if (_e81.member_4 == 0u) {
                        phi_1043_ = array<u32, 3>(_e740[0], _e740[1], 0u);
                    } else {
                        phi_1043_ = _e740;
                    }
                    let _e746 = phi_1043_;
                    let _e751 = (_e746[0] | (_e746[1] << bitcast<u32>(16i)));
                    sums[_e67] = _e751;
                    phi_1052_ = type_9(0u, 7u);
                    phi_1055_ = 0u;
                    phi_1057_ = 1u;
                    phi_1059_ = _e751;
                    phi_1056_ = 128u;
                    loop {
                        let _e754 = phi_1052_;
                        let _e756 = phi_1055_;
                        let _e758 = phi_1057_;
                        let _e760 = phi_1059_;
                        let _e762 = phi_1056_;
                        local = _e760;
                        if (_e754.member < _e754.member_1) {
                            phi_1053_ = type_9((_e754.member + 1u), _e754.member_1);
                            phi_1082_ = type_9(1u, _e754.member);
                        } else {
                            phi_1053_ = _e754;
                            phi_1082_ = type_9(0u, type_9().member_1);
                        }
                        let _e774 = phi_1053_;
                        let _e776 = phi_1082_;
                        let _e779 = (bitcast<i32>(_e776.member) != 0i);
                        if _e779 {
                            workgroupBarrier();
                            if (_e67 >= _e758) {
                                let _e784 = sums[((_e756 + _e67) - _e758)];
                                phi_1098_ = (_e760 + _e784);
                            } else {
                                phi_1098_ = _e760;
                            }
                            let _e787 = phi_1098_;
                            sums[(_e762 + _e67)] = _e787;
                            phi_1058_ = (_e758 * 2u);
                            phi_1060_ = _e787;
                        } else {
                            phi_1058_ = u32();
                            phi_1060_ = u32();
                        }
                        let _e792 = phi_1058_;
                        let _e794 = phi_1060_;
                        continue;
                        continuing {
                            phi_1052_ = _e774;
                            phi_1055_ = _e762;
                            phi_1057_ = _e792;
                            phi_1059_ = _e794;
                            phi_1056_ = _e756;
                            break if !(_e779);
                        }
                    }
                    workgroupBarrier();
                    let _e797 = local;
                    let _e798 = (_e797 - _e751);
                    if (_e67 == 0u) {
                        let _e801 = sums[255u];
                        atomicStore((&shared_[6u]), (_e801 & 65535u));
                        atomicStore((&shared_[7u]), (_e801 >> bitcast<u32>(16i)));
                    }
                    if (_e81.member_4 > 0u) {
                        sums[_e67] = _e746[2];
                        phi_1126_ = type_9(0u, 7u);
                        phi_1129_ = 0u;
                        phi_1131_ = 1u;
                        phi_1133_ = _e746[2];
                        phi_1130_ = 128u;
                        loop {
                            let _e812 = phi_1126_;
                            let _e814 = phi_1129_;
                            let _e816 = phi_1131_;
                            let _e818 = phi_1133_;
                            let _e820 = phi_1130_;
                            local_1 = _e818;
                            if (_e812.member < _e812.member_1) {
                                phi_1127_ = type_9((_e812.member + 1u), _e812.member_1);
                                phi_1156_ = type_9(1u, _e812.member);
                            } else {
                                phi_1127_ = _e812;
                                phi_1156_ = type_9(0u, type_9().member_1);
                            }
                            let _e832 = phi_1127_;
                            let _e834 = phi_1156_;
                            let _e837 = (bitcast<i32>(_e834.member) != 0i);
                            if _e837 {
                                workgroupBarrier();
                                if (_e67 >= _e816) {
                                    let _e842 = sums[((_e814 + _e67) - _e816)];
                                    phi_1172_ = (_e818 + _e842);
                                } else {
                                    phi_1172_ = _e818;
                                }
                                let _e845 = phi_1172_;
                                sums[(_e820 + _e67)] = _e845;
                                phi_1132_ = (_e816 * 2u);
                                phi_1134_ = _e845;
                            } else {
                                phi_1132_ = u32();
                                phi_1134_ = u32();
                            }
                            let _e850 = phi_1132_;
                            let _e852 = phi_1134_;
                            continue;
                            continuing {
                                phi_1126_ = _e832;
                                phi_1129_ = _e820;
                                phi_1131_ = _e850;
                                phi_1133_ = _e852;
                                phi_1130_ = _e814;
                                break if !(_e837);
                            }
                        }
                        workgroupBarrier();
                        let _e856 = local_1;
                        if (_e67 == 0u) {
                            let _e860 = sums[255u];
                            atomicStore((&shared_[8u]), _e860);
                        }
                        phi_1187_ = (_e856 - _e746[2]);
                    } else {
                        phi_1187_ = 0u;
                    }
                    let _e863 = phi_1187_;
                    if (_e339 > 1u) {
                        phi_1194_ = 1u;
                    } else {
                        phi_1194_ = 2u;
                    }
                    let _e869 = phi_1194_;
                    if (_e869 == 1u) {
                        phi_1199_ = (_e798 & 65535u);
                    } else {
                        phi_1199_ = (_e798 >> bitcast<u32>(16i));
                    }
                    let _e872 = phi_1199_;
                    phi_1272_ = array<u32, 2>(_e872, _e863);
                } else {
                    let _e672 = countOneBits(_e666);
                    if (_e339 > 1u) {
                        phi_1210_ = 1u;
                    } else {
                        phi_1210_ = 2u;
                    }
                    let _e678 = phi_1210_;
                    if (_e678 == 1u) {
                        phi_1217_ = array<u32, 3>(_e672, 0u, countOneBits(_e668));
                    } else {
                        phi_1217_ = array<u32, 3>(0u, _e672, (countOneBits(_e668) + _e672));
                    }
                    let _e683 = phi_1217_;
                    if (_e81.member_4 == 0u) {
                        phi_1223_ = array<u32, 3>(_e683[0], _e683[1], 0u);
                    } else {
                        phi_1223_ = _e683;
                    }
                    let _e689 = phi_1223_;
                    if (_e689[0] > 0u) {
                        let _e694 = atomicAdd((&shared_[6u]), _e689[0]);
                        phi_1235_ = array<u32, 3>(_e694, 0u, 0u);
                    } else {
                        phi_1235_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e697 = phi_1235_;
                    if (_e689[1] > 0u) {
                        let _e702 = atomicAdd((&shared_[7u]), _e689[1]);
                        phi_1246_ = array<u32, 3>(_e697[0], _e702, _e697[2]);
                    } else {
                        phi_1246_ = _e697;
                    }
                    let _e707 = phi_1246_;
                    if (_e689[2] > 0u) {
                        let _e712 = atomicAdd((&shared_[8u]), _e689[2]);
                        phi_1257_ = array<u32, 3>(_e707[0], _e707[1], _e712);
                    } else {
                        phi_1257_ = _e707;
                    }
                    let _e717 = phi_1257_;
                    if (_e339 > 1u) {
                        phi_1262_ = 1u;
                    } else {
                        phi_1262_ = 2u;
                    }
                    let _e720 = phi_1262_;
                    if (_e720 == 1u) {
                        phi_1269_ = _e717[0];
                    } else {
                        phi_1269_ = _e717[1];
                    }
                    let _e725 = phi_1269_;
                    phi_1272_ = array<u32, 2>(_e725, _e717[2]);
                }
                let _e875 = phi_1272_;
                workgroupBarrier();
                if (_e67 == 0u) {
                    let _e878 = atomicLoad((&shared_[6u]));
                    let _e880 = atomicLoad((&shared_[7u]));
                    let _e882 = atomicLoad((&shared_[8u]));
                    let _e884 = atomicLoad((&shared_[1u]));
                    let _e886 = atomicLoad((&shared_[2u]));
                    let _e888 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e888 + 1u));
                    let _e892 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e892 + _e884) + _e886));
                    let _e897 = atomicLoad((&shared_[0u]));
                    let _e898 = (_e897 - _e884);
                    let _e900 = (_e81.member_10 - _e898);
                    if (_e900 < _e878) {
                        phi_1316_ = _e900;
                    } else {
                        phi_1316_ = _e878;
                    }
                    let _e903 = phi_1316_;
                    atomicStore((&shared_[9u]), _e898);
                    atomicStore((&shared_[10u]), _e903);
                    atomicStore((&shared_[0u]), (_e898 + _e903));
                    if (_e878 > _e903) {
                        let _e909 = (_e878 - _e903);
                        if (_e81.member_13 == 0u) {
                        } else {
                            let _e913 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e916 = atomicAdd((&control.member[(_e83.member_1 + 1u)]), _e909);
                        let _e919 = atomicMax((&nodes.member[0u]), (_e916 + _e909));
                        if ((_e916 + _e909) < _e916) {
                            let _e923 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e916);
                    }
                    if (_e880 > 0u) {
                        let _e927 = atomicAdd((&pairs.member[0u]), _e880);
                        if ((_e927 + _e880) < _e927) {
                            let _e931 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e927);
                    }
                    if (_e882 > 0u) {
                        let _e935 = atomicAdd((&control.member[1537u]), _e882);
                        if ((_e935 + _e882) < _e935) {
                            let _e939 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e935);
                    }
                }
                workgroupBarrier();
                if (_e339 > 1u) {
                    phi_1403_ = 1u;
                } else {
                    phi_1403_ = 2u;
                }
                let _e946 = phi_1403_;
                phi_1406_ = type_9(0u, 32u);
                phi_1409_ = _e875[1];
                phi_1411_ = _e875[0];
                phi_1413_ = (_e666 | _e668);
                loop {
                    let _e948 = phi_1406_;
                    let _e950 = phi_1409_;
                    let _e952 = phi_1411_;
                    let _e954 = phi_1413_;
                    if (_e948.member < _e948.member_1) {
                        phi_1407_ = type_9((_e948.member + 1u), _e948.member_1);
                        phi_1436_ = type_9(1u, _e948.member);
                    } else {
                        phi_1407_ = _e948;
                        phi_1436_ = type_9(0u, type_9().member_1);
                    }
                    let _e966 = phi_1407_;
                    let _e968 = phi_1436_;
                    if (bitcast<i32>(_e968.member) != 0i) {
                        if (_e954 == 0u) {
                            phi_1567_ = u32();
                            phi_1568_ = u32();
                            phi_1569_ = u32();
                            phi_1570_ = false;
                        } else {
                            let _e975 = select(firstTrailingBit(_e954), 32u, (_e954 == 0u));
                            let _e978 = (_e342 + _e975);
                            let _e981 = ((_e339 << bitcast<u32>(27u)) | _e341);
                            if (((_e668 >> bitcast<u32>((_e975 & 31u))) & 1u) == 1u) {
                                phi_1462_ = 3u;
                            } else {
                                phi_1462_ = _e946;
                            }
                            let _e988 = phi_1462_;
                            if (_e988 == 1u) {
                                let _e1021 = atomicLoad((&shared_[10u]));
                                if (_e952 < _e1021) {
                                    let _e1037 = atomicLoad((&shared_[9u]));
                                    let _e1039 = (2u * (_e1037 + _e952));
                                    stack[_e1039] = _e981;
                                    stack[(_e1039 + 1u)] = _e978;
                                } else {
                                    let _e1024 = atomicLoad((&shared_[11u]));
                                    let _e1026 = ((_e1024 + _e952) - _e1021);
                                    if (_e1026 < _e81.member_3) {
                                        let _e1029 = (_e94 + _e1026);
                                        if (_e1029 < 4294967295u) {
                                            let _e1031 = (2u * _e1029);
                                            atomicStore((&nodes.member[(4u + _e1031)]), _e981);
                                            atomicStore((&nodes.member[(_e1031 + 5u)]), _e978);
                                        }
                                    }
                                }
                            } else {
                                if (_e988 == 0u) {
                                } else {
                                    if (_e988 == 2u) {
                                        let _e994 = params.member.member_1;
                                        let _e997 = atomicLoad((&shared_[12u]));
                                        let _e998 = (_e997 + _e952);
                                        if (_e998 < _e994.member_3) {
                                            let _e1000 = (2u * _e998);
                                            atomicStore((&pairs.member[(4u + _e1000)]), (_e981 & 134217727u));
                                            atomicStore((&pairs.member[(_e1000 + 5u)]), _e978);
                                        }
                                    }
                                    if (_e81.member_4 > 0u) {
                                        let _e1008 = atomicLoad((&shared_[13u]));
                                        let _e1009 = (_e1008 + _e950);
                                        if (_e1009 < _e81.member_4) {
                                            let _e1016 = (2u * ((_e81.member_5 * _e81.member_4) + _e1009));
                                            front.member[_e1016] = _e981;
                                            front.member[(_e1016 + 1u)] = _e978;
                                        }
                                    }
                                }
                            }
                            phi_1567_ = (_e950 + select(0u, 1u, (_e988 != 1u)));
                            phi_1568_ = (_e952 + select(0u, 1u, (_e988 != 3u)));
                            phi_1569_ = (_e954 & (_e954 - 1u));
                            phi_1570_ = true;
                        }
                        let _e1050 = phi_1567_;
                        let _e1052 = phi_1568_;
                        let _e1054 = phi_1569_;
                        let _e1056 = phi_1570_;
                        phi_1410_ = _e1050;
                        phi_1412_ = _e1052;
                        phi_1414_ = _e1054;
                        phi_1571_ = _e1056;
                    } else {
                        phi_1410_ = u32();
                        phi_1412_ = u32();
                        phi_1414_ = u32();
                        phi_1571_ = false;
                    }
                    let _e1058 = phi_1410_;
                    let _e1060 = phi_1412_;
                    let _e1062 = phi_1414_;
                    let _e1064 = phi_1571_;
                    continue;
                    continuing {
                        phi_1406_ = _e966;
                        phi_1409_ = _e1058;
                        phi_1411_ = _e1060;
                        phi_1413_ = _e1062;
                        break if !(_e1064);
                    }
                }
                phi_1572_ = true;
            }
            let _e1067 = phi_1572_;
            phi_1573_ = _e1067;
        } else {
            phi_1573_ = false;
        }
        let _e1069 = phi_1573_;
        continue;
        continuing {
            phi_215_ = _e115;
            break if !(_e1069);
        }
    }
    if (_e67 == 0u) {
        if (_e81.member_6 == 0u) {
            if (_e78 < _e91) {
                phi_1596_ = ((((_e91 - 1u) - _e78) >> bitcast<u32>((_e81.member_7 & 31u))) + 1u);
            } else {
                phi_1596_ = 0u;
            }
            let _e1083 = phi_1596_;
            let _e1085 = atomicLoad((&shared_[5u]));
            phi_1601_ = (_e1083 - _e1085);
        } else {
            phi_1601_ = 0u;
        }
        let _e1088 = phi_1601_;
        atomicStore((&shared_[14u]), _e1088);
        let _e1091 = atomicLoad((&shared_[0u]));
        let _e1092 = (_e1091 + _e1088);
        if (_e81.member_6 == 2u) {
            let _e1119 = (((_e91 + (1u << bitcast<u32>((_e81.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e81.member_7 & 31u)));
            let _e1120 = (_e78 * _e1119);
            if (_e91 < _e1120) {
                phi_1627_ = _e91;
            } else {
                phi_1627_ = _e1120;
            }
            let _e1123 = phi_1627_;
            let _e1124 = (_e91 - _e1123);
            if (_e1124 < _e1119) {
                phi_1633_ = _e1124;
            } else {
                phi_1633_ = _e1119;
            }
            let _e1127 = phi_1633_;
            let _e1134 = ((1540u + (2u * (1u << bitcast<u32>((_e81.member_7 & 31u))))) + (2u * _e78));
            let _e1136 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e1134]), _e1136);
            let _e1140 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e1134 + 1u)]), (_e1127 - _e1140));
        } else {
            if (_e1092 > 0u) {
                if (_e81.member_13 == 0u) {
                } else {
                    let _e1099 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e1102 = atomicAdd((&control.member[(_e83.member_1 + 1u)]), _e1092);
                let _e1105 = atomicMax((&nodes.member[0u]), (_e1102 + _e1092));
                if ((_e1102 + _e1092) < _e1102) {
                    let _e1109 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e1102);
            }
        }
        let _e1146 = atomicLoad((&shared_[15u]));
        let _e1148 = atomicAdd((&control.member[(1540u + (2u * _e78))]), _e1146);
        let _e1152 = atomicLoad((&shared_[16u]));
        let _e1154 = atomicAdd((&control.member[((2u * _e78) + 1541u)]), _e1152);
    }
    workgroupBarrier();
    let _e1156 = atomicLoad((&shared_[0u]));
    let _e1158 = atomicLoad((&shared_[17u]));
    let _e1160 = atomicLoad((&shared_[14u]));
    phi_1721_ = type_9(0u, 8u);
    loop {
        let _e1162 = phi_1721_;
        if (_e1162.member < _e1162.member_1) {
            phi_1722_ = type_9((_e1162.member + 1u), _e1162.member_1);
            phi_1745_ = type_9(1u, _e1162.member);
        } else {
            phi_1722_ = _e1162;
            phi_1745_ = type_9(0u, type_9().member_1);
        }
        let _e1174 = phi_1722_;
        let _e1176 = phi_1745_;
        let _e1180 = (bitcast<i32>(_e1176.member) != 0i);
        if _e1180 {
            let _e1182 = ((_e1176.member_1 * 128u) + _e67);
            if (_e1182 < _e1156) {
                let _e1186 = stack[(2u * _e1182)];
                let _e1190 = stack[((2u * _e1182) + 1u)];
                if (_e81.member_6 == 2u) {
                    let _e1222 = ((((((1540u + (2u * (1u << bitcast<u32>((_e81.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e81.member_7 & 31u))))) + (1u << bitcast<u32>((_e81.member_7 & 31u)))) + 1u) + (_e78 * 2048u)) + (2u * _e1182));
                    atomicStore((&control.member[_e1222]), _e1186);
                    atomicStore((&control.member[(_e1222 + 1u)]), _e1190);
                } else {
                    let _e1193 = (_e1158 + _e1182);
                    if (_e1193 < _e81.member_3) {
                        let _e1196 = (_e94 + _e1193);
                        if (_e1196 < 4294967295u) {
                            let _e1198 = (2u * _e1196);
                            atomicStore((&nodes.member[(4u + _e1198)]), _e1186);
                            atomicStore((&nodes.member[(_e1198 + 5u)]), _e1190);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1721_ = _e1174;
            break if !(_e1180);
        }
    }
    let _e1228 = atomicLoad((&shared_[5u]));
    let _e1229 = (_e1160 / 128u);
    if ((_e1160 % 128u) > 0u) {
        phi_1836_ = (_e1229 + 1u);
    } else {
        phi_1836_ = _e1229;
    }
    let _e1234 = phi_1836_;
    phi_1839_ = type_9(0u, _e1234);
    loop {
        let _e1237 = phi_1839_;
        if (_e1237.member < _e1237.member_1) {
            phi_1840_ = type_9((_e1237.member + 1u), _e1237.member_1);
            phi_1863_ = type_9(1u, _e1237.member);
        } else {
            phi_1840_ = _e1237;
            phi_1863_ = type_9(0u, type_9().member_1);
        }
        let _e1249 = phi_1840_;
        let _e1251 = phi_1863_;
        let _e1255 = (bitcast<i32>(_e1251.member) != 0i);
        if _e1255 {
            let _e1257 = ((_e1251.member_1 * 128u) + _e67);
            if (_e1257 < _e1160) {
                let _e1266 = (2u * ((_e92 + _e78) + ((_e1228 + _e1257) << bitcast<u32>((_e81.member_7 & 31u)))));
                let _e1269 = atomicLoad((&nodes.member[(4u + _e1266)]));
                let _e1272 = atomicLoad((&nodes.member[(_e1266 + 5u)]));
                let _e1274 = ((_e1158 + _e1156) + _e1257);
                if (_e1274 < _e81.member_3) {
                    let _e1277 = (_e94 + _e1274);
                    if (_e1277 < 4294967295u) {
                        let _e1279 = (2u * _e1277);
                        atomicStore((&nodes.member[(4u + _e1279)]), _e1269);
                        atomicStore((&nodes.member[(_e1279 + 5u)]), _e1272);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1839_ = _e1249;
            break if !(_e1255);
        }
    }
    if (_e81.member_6 == 1u) {
        if (_e1228 == 0u) {
            phi_1944_ = type_9(0u, _e91);
            loop {
                let _e1290 = phi_1944_;
                if (_e1290.member < _e1290.member_1) {
                    phi_1945_ = type_9((_e1290.member + 1u), _e1290.member_1);
                    phi_1968_ = type_9(1u, _e1290.member);
                } else {
                    phi_1945_ = _e1290;
                    phi_1968_ = type_9(0u, type_9().member_1);
                }
                let _e1302 = phi_1945_;
                let _e1304 = phi_1968_;
                if (bitcast<i32>(_e1304.member) != 0i) {
                    let _e1310 = atomicAdd((&control.member[(512u + _e83.member_1)]), 1u);
                    if (_e1310 >= _e91) {
                        phi_2060_ = false;
                    } else {
                        let _e1313 = (2u * (_e92 + _e1310));
                        let _e1316 = atomicLoad((&nodes.member[(4u + _e1313)]));
                        let _e1319 = atomicLoad((&nodes.member[(_e1313 + 5u)]));
                        if (_e81.member_13 == 0u) {
                        } else {
                            let _e1323 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1326 = atomicAdd((&control.member[(_e83.member_1 + 1u)]), 1u);
                        let _e1329 = atomicMax((&nodes.member[0u]), (_e1326 + 1u));
                        if ((_e1326 + 1u) < _e1326) {
                            let _e1333 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1326 < _e81.member_3) {
                            let _e1336 = (_e94 + _e1326);
                            if (_e1336 < 4294967295u) {
                                let _e1338 = (2u * _e1336);
                                atomicStore((&nodes.member[(4u + _e1338)]), _e1316);
                                atomicStore((&nodes.member[(_e1338 + 5u)]), _e1319);
                            }
                        }
                        phi_2060_ = true;
                    }
                    let _e1344 = phi_2060_;
                    phi_2061_ = _e1344;
                } else {
                    phi_2061_ = false;
                }
                let _e1346 = phi_2061_;
                continue;
                continuing {
                    phi_1944_ = _e1302;
                    break if !(_e1346);
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
