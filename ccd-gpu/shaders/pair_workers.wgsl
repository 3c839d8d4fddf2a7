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
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_19 {
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
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_25 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> a_nodes: type_18;
@group(0) @binding(2) 
var<storage> b_nodes: type_18;
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_28;
@group(0) @binding(3) 
var<storage, read_write> control: type_28;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_28;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_144_: u32;
    var phi_161_: type_9;
    var phi_162_: type_9;
    var phi_185_: type_9;
    var phi_203_: u32;
    var phi_233_: bool;
    var phi_237_: u32;
    var phi_238_: u32;
    var phi_239_: u32;
    var phi_293_: u32;
    var phi_298_: u32;
    var phi_303_: u32;
    var phi_312_: u32;
    var phi_318_: u32;
    var phi_324_: u32;
    var phi_265_: u32;
    var phi_271_: u32;
    var phi_325_: u32;
    var phi_326_: u32;
    var phi_327_: u32;
    var phi_346_: u32;
    var phi_347_: u32;
    var phi_416_: array<u32, 2>;
    var phi_417_: array<u32, 2>;
    var phi_431_: array<u32, 2>;
    var phi_457_: u32;
    var phi_527_: array<u32, 2>;
    var phi_541_: array<u32, 2>;
    var phi_578_: array<u32, 2>;
    var phi_580_: type_23;
    var phi_581_: type_23;
    var phi_582_: bool;
    var phi_583_: type_23;
    var phi_584_: bool;
    var phi_600_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_755_: array<u32, 2>;
    var phi_784_: array<u32, 2>;
    var phi_813_: array<u32, 2>;
    var phi_842_: array<u32, 2>;
    var phi_844_: type_23;
    var phi_845_: bool;
    var phi_846_: type_23;
    var phi_847_: bool;
    var phi_1020_: array<u32, 2>;
    var phi_1052_: array<u32, 2>;
    var phi_920_: array<u32, 2>;
    var phi_952_: array<u32, 2>;
    var phi_1054_: type_23;
    var phi_1055_: type_23;
    var phi_1056_: type_23;
    var phi_1057_: bool;
    var phi_1058_: type_23;
    var phi_1059_: type_23;
    var phi_1060_: bool;
    var phi_1064_: type_23;
    var phi_1074_: array<array<u32, 2>, 4>;
    var phi_1092_: bool;
    var phi_1093_: bool;
    var phi_1097_: u32;
    var phi_1098_: u32;
    var phi_1110_: type_25;
    var phi_1111_: type_25;
    var phi_1129_: bool;
    var phi_1130_: bool;
    var phi_1134_: u32;
    var phi_1135_: u32;
    var phi_1147_: type_25;
    var phi_1148_: type_25;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1171_: u32;
    var phi_1172_: u32;
    var phi_1184_: type_25;
    var phi_1185_: type_25;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_1208_: u32;
    var phi_1209_: u32;
    var phi_1221_: type_25;
    var phi_1222_: type_25;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1243_: u32;
    var phi_1244_: u32;
    var phi_1250_: type_25;
    var phi_1251_: type_25;
    var phi_1252_: type_25;
    var phi_1253_: type_25;
    var phi_1254_: type_25;
    var phi_1273_: array<u32, 2>;
    var phi_1274_: array<u32, 2>;
    var phi_1286_: array<u32, 2>;
    var phi_1287_: array<u32, 2>;
    var phi_1304_: array<u32, 2>;
    var phi_1305_: array<u32, 2>;
    var phi_1317_: array<u32, 2>;
    var phi_1318_: array<u32, 2>;
    var phi_1335_: array<u32, 2>;
    var phi_1336_: array<u32, 2>;
    var phi_1348_: array<u32, 2>;
    var phi_1349_: array<u32, 2>;
    var phi_1366_: array<u32, 2>;
    var phi_1367_: array<u32, 2>;
    var phi_1379_: array<u32, 2>;
    var phi_1380_: array<u32, 2>;
    var phi_1413_: u32;
    var phi_1573_: type_9;
    var phi_1578_: type_9;
    var phi_1714_: type_9;
    var phi_1719_: type_9;
    var phi_1855_: type_9;
    var phi_1860_: type_9;
    var phi_1996_: type_9;
    var phi_2001_: type_9;
    var phi_2045_: bool;
    var phi_2046_: bool;
    var phi_2065_: u32;
    var phi_2069_: u32;
    var phi_2126_: type_9;
    var phi_2127_: type_9;
    var phi_2150_: type_9;
    var phi_2206_: u32;
    var phi_2209_: type_9;
    var phi_2210_: type_9;
    var phi_2233_: type_9;
    var phi_2305_: type_9;
    var phi_2306_: type_9;
    var phi_2329_: type_9;
    var phi_2409_: bool;
    var phi_2410_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e54 = id_2;
    let _e55 = n_2;
    let _e56 = lane_2;
    let _e68 = ((_e54.y * _e55.x) + _e54.x);
    let _e70 = params.member.member_2;
    let _e73 = params.member.member_1.member_1;
    let _e75 = (_e73 % 2u);
    let _e78 = atomicLoad((&control.member[_e73]));
    if (_e70.member_3 < _e78) {
        phi_144_ = _e70.member_3;
    } else {
        phi_144_ = _e78;
    }
    let _e81 = phi_144_;
    let _e82 = (_e75 * _e70.member_3);
    let _e84 = ((1u - _e75) * _e70.member_3);
    let _e86 = params.member.member_1.member_3;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_161_ = type_9(0u, _e70.member_11);
    loop {
        let _e95 = phi_161_;
        if (_e95.member < _e95.member_1) {
            phi_162_ = type_9((_e95.member + 1u), _e95.member_1);
            phi_185_ = type_9(1u, _e95.member);
        } else {
            phi_162_ = _e95;
            phi_185_ = type_9(0u, type_9().member_1);
        }
        let _e107 = phi_162_;
        let _e109 = phi_185_;
        if (bitcast<i32>(_e109.member) != 0i) {
            if (_e56 == 0u) {
                let _e116 = atomicLoad((&shared_[0u]));
                if (128u < _e116) {
                    phi_203_ = 128u;
                } else {
                    phi_203_ = _e116;
                }
                let _e119 = phi_203_;
                if (_e70.member_9 > 0u) {
                    if (_e109.member_1 >= 16u) {
                        let _e125 = atomicLoad((&control.member[(1024u + _e73)]));
                        if (_e70.member_9 > 0u) {
                            phi_233_ = ((_e125 * 100u) >= (_e70.member_9 << bitcast<u32>((_e70.member_7 & 31u))));
                        } else {
                            phi_233_ = false;
                        }
                        let _e134 = phi_233_;
                        if _e134 {
                            phi_237_ = 2u;
                        } else {
                            phi_237_ = 0u;
                        }
                        let _e136 = phi_237_;
                        phi_238_ = _e136;
                    } else {
                        phi_238_ = 0u;
                    }
                    let _e138 = phi_238_;
                    phi_239_ = _e138;
                } else {
                    phi_239_ = 0u;
                }
                let _e140 = phi_239_;
                let _e141 = (128u - _e119);
                if (_e140 == 0u) {
                    if (_e141 > 0u) {
                        let _e145 = atomicLoad((&shared_[5u]));
                        if (_e70.member_6 == 0u) {
                            if (_e68 < _e81) {
                                phi_265_ = ((((_e81 - 1u) - _e68) >> bitcast<u32>((_e70.member_7 & 31u))) + 1u);
                            } else {
                                phi_265_ = 0u;
                            }
                            let _e188 = phi_265_;
                            let _e189 = (_e188 - _e145);
                            if (_e141 < _e189) {
                                phi_271_ = _e141;
                            } else {
                                phi_271_ = _e189;
                            }
                            let _e192 = phi_271_;
                            atomicStore((&shared_[3u]), (_e68 + (_e145 << bitcast<u32>((_e70.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e70.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e145 + _e192));
                            phi_325_ = _e192;
                        } else {
                            if (_e145 == 0u) {
                                let _e153 = (_e81 >> bitcast<u32>(((_e70.member_7 + 2u) & 31u)));
                                if (_e70.member_8 < _e153) {
                                    phi_293_ = _e153;
                                } else {
                                    phi_293_ = _e70.member_8;
                                }
                                let _e156 = phi_293_;
                                if (128u < _e156) {
                                    phi_298_ = 128u;
                                } else {
                                    phi_298_ = _e156;
                                }
                                let _e159 = phi_298_;
                                if (_e141 < _e159) {
                                    phi_303_ = _e141;
                                } else {
                                    phi_303_ = _e159;
                                }
                                let _e162 = phi_303_;
                                let _e165 = atomicAdd((&control.member[(512u + _e73)]), _e162);
                                if (_e81 < _e165) {
                                    phi_312_ = _e81;
                                } else {
                                    phi_312_ = _e165;
                                }
                                let _e168 = phi_312_;
                                let _e169 = (_e81 - _e168);
                                if (_e162 < _e169) {
                                    phi_318_ = _e162;
                                } else {
                                    phi_318_ = _e169;
                                }
                                let _e172 = phi_318_;
                                atomicStore((&shared_[3u]), _e165);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e172 < _e162)));
                                phi_324_ = _e172;
                            } else {
                                phi_324_ = 0u;
                            }
                            let _e179 = phi_324_;
                            phi_325_ = _e179;
                        }
                        let _e205 = phi_325_;
                        phi_326_ = _e205;
                    } else {
                        phi_326_ = 0u;
                    }
                    let _e207 = phi_326_;
                    phi_327_ = _e207;
                } else {
                    phi_327_ = 0u;
                }
                let _e209 = phi_327_;
                if (_e140 == 0u) {
                    if ((_e119 + _e209) == 0u) {
                        if (_e70.member_9 > 0u) {
                            let _e217 = atomicAdd((&control.member[(1024u + _e73)]), 1u);
                        }
                        phi_346_ = 1u;
                    } else {
                        phi_346_ = _e140;
                    }
                    let _e219 = phi_346_;
                    phi_347_ = _e219;
                } else {
                    phi_347_ = _e140;
                }
                let _e221 = phi_347_;
                atomicStore((&shared_[1u]), _e119);
                atomicStore((&shared_[2u]), _e209);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e221;
            }
            let _e229 = workgroupUniformLoad((&state[0u]));
            if (_e229 != 0u) {
                phi_2045_ = false;
            } else {
                let _e232 = atomicLoad((&shared_[1u]));
                let _e234 = atomicLoad((&shared_[2u]));
                if (_e56 < _e232) {
                    let _e257 = atomicLoad((&shared_[0u]));
                    let _e260 = (2u * ((_e257 - 1u) - _e56));
                    let _e262 = stack[_e260];
                    let _e265 = stack[(_e260 + 1u)];
                    phi_417_ = array<u32, 2>(_e262, _e265);
                } else {
                    if (_e56 < (_e232 + _e234)) {
                        let _e239 = atomicLoad((&shared_[3u]));
                        let _e242 = atomicLoad((&shared_[4u]));
                        let _e246 = (2u * (_e82 + (_e239 + ((_e56 - _e232) * _e242))));
                        let _e249 = atomicLoad((&nodes.member[(4u + _e246)]));
                        let _e252 = atomicLoad((&nodes.member[(_e246 + 5u)]));
                        phi_416_ = array<u32, 2>(_e249, _e252);
                    } else {
                        phi_416_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e255 = phi_416_;
                    phi_417_ = _e255;
                }
                let _e268 = phi_417_;
                let _e271 = params.member.member_2.member;
                let _e275 = params.member.member_2.member;
                if (_e275 == 0u) {
                    phi_431_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_431_ = array<u32, 2>(1u, 1u);
                }
                let _e278 = phi_431_;
                let _e284 = params.member.member.member[_e278[0]];
                let _e285 = (_e284 - 1u);
                let _e289 = params.member.member.member[_e278[1]];
                let _e290 = (_e289 - 1u);
                let _e293 = params.member.member_2.member_1;
                if (_e293 == 0u) {
                    phi_457_ = 1u;
                } else {
                    phi_457_ = 0u;
                }
                let _e296 = phi_457_;
                if (_e268[0] != 4294967295u) {
                    let _e302 = a_nodes.member[_e268[0]];
                    let _e304 = b_nodes.member[_e268[1]];
                    if (_e271 == 1u) {
                        if (_e268[0] == _e268[1]) {
                            if (_e302.member_3 == 4294967295u) {
                                phi_580_ = type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e310 = a_nodes.member[_e302.member_1];
                                let _e313 = a_nodes.member[_e302.member_3];
                                if !((_e310.member_3 == 4294967295u)) {
                                    phi_527_ = array<u32, 2>(_e302.member_1, _e302.member_1);
                                } else {
                                    phi_527_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e320 = phi_527_;
                                let _e327 = type_23(array<array<u32, 2>, 4>(_e320, type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e339 = type_23(array<array<u32, 2>, 4>(_e327.member[0], array<u32, 2>(_e302.member_1, _e327.member[1][1]), _e327.member[2], _e327.member[3]), _e327.member_1);
                                let _e340 = array<u32, 2>(_e302.member_1, _e302.member_3);
                                let _e347 = type_23(array<array<u32, 2>, 4>(_e339.member[0], _e340, _e339.member[2], _e339.member[3]), _e339.member_1);
                                if !((_e313.member_3 == 4294967295u)) {
                                    phi_541_ = array<u32, 2>(_e302.member_3, _e302.member_3);
                                } else {
                                    phi_541_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e354 = phi_541_;
                                let _e361 = type_23(array<array<u32, 2>, 4>(_e347.member[0], _e347.member[1], _e354, _e347.member[3]), _e347.member_1);
                                let _e364 = type_23(_e361.member, _e361.member);
                                if ((((((_e310.member[0] <= _e313.member_2[0]) && (_e313.member[0] <= _e310.member_2[0])) && (_e310.member[1] <= _e313.member_2[1])) && (_e313.member[1] <= _e310.member_2[1])) && (_e310.member[2] <= _e313.member_2[2])) && (_e313.member[2] <= _e310.member_2[2])) {
                                    phi_578_ = _e340;
                                } else {
                                    phi_578_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e393 = phi_578_;
                                phi_580_ = type_23(_e364.member, array<array<u32, 2>, 4>(_e364.member_1[0], _e393, _e364.member_1[2], _e364.member_1[3]));
                            }
                            let _e402 = phi_580_;
                            phi_581_ = _e402;
                            phi_582_ = false;
                        } else {
                            phi_581_ = type_23();
                            phi_582_ = true;
                        }
                        let _e404 = phi_581_;
                        let _e406 = phi_582_;
                        phi_583_ = _e404;
                        phi_584_ = _e406;
                    } else {
                        phi_583_ = type_23();
                        phi_584_ = true;
                    }
                    let _e408 = phi_583_;
                    let _e410 = phi_584_;
                    if _e410 {
                        let _e413 = !((_e302.member_3 == 4294967295u));
                        let _e416 = !((_e304.member_3 == 4294967295u));
                        if _e413 {
                            phi_600_ = true;
                        } else {
                            phi_600_ = _e416;
                        }
                        let _e418 = phi_600_;
                        if _e418 {
                            if _e413 {
                                if _e416 {
                                    if (_e296 == 0u) {
                                        let _e446 = ((((_e304.member_2[0] - _e304.member[0]) * (_e304.member_2[1] - _e304.member[1])) * (_e304.member_2[2] - _e304.member[2])) > (((_e302.member_2[0] - _e302.member[0]) * (_e302.member_2[1] - _e302.member[1])) * (_e302.member_2[2] - _e302.member[2])));
                                        phi_644_ = _e446;
                                        phi_645_ = !(_e446);
                                    } else {
                                        phi_644_ = _e416;
                                        phi_645_ = _e413;
                                    }
                                    let _e449 = phi_644_;
                                    let _e451 = phi_645_;
                                    phi_646_ = _e449;
                                    phi_647_ = _e451;
                                } else {
                                    phi_646_ = _e416;
                                    phi_647_ = _e413;
                                }
                                let _e453 = phi_646_;
                                let _e455 = phi_647_;
                                phi_648_ = _e453;
                                phi_649_ = _e455;
                            } else {
                                phi_648_ = _e416;
                                phi_649_ = _e413;
                            }
                            let _e457 = phi_648_;
                            let _e459 = phi_649_;
                            if _e459 {
                                if _e457 {
                                    let _e462 = a_nodes.member[_e302.member_1];
                                    let _e467 = a_nodes.member[_e302.member_3];
                                    let _e472 = b_nodes.member[_e304.member_1];
                                    let _e477 = b_nodes.member[_e304.member_3];
                                    let _e482 = array<u32, 2>(_e302.member_1, _e304.member_1);
                                    let _e485 = array<u32, 2>(_e302.member_1, _e304.member_3);
                                    let _e488 = array<u32, 2>(_e302.member_3, _e304.member_1);
                                    let _e491 = array<u32, 2>(_e302.member_3, _e304.member_3);
                                    if ((((((_e462.member[0] <= _e472.member_2[0]) && (_e472.member[0] <= _e462.member_2[0])) && (_e462.member[1] <= _e472.member_2[1])) && (_e472.member[1] <= _e462.member_2[1])) && (_e462.member[2] <= _e472.member_2[2])) && (_e472.member[2] <= _e462.member_2[2])) {
                                        phi_755_ = _e482;
                                    } else {
                                        phi_755_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e517 = phi_755_;
                                    if ((((((_e462.member[0] <= _e477.member_2[0]) && (_e477.member[0] <= _e462.member_2[0])) && (_e462.member[1] <= _e477.member_2[1])) && (_e477.member[1] <= _e462.member_2[1])) && (_e462.member[2] <= _e477.member_2[2])) && (_e477.member[2] <= _e462.member_2[2])) {
                                        phi_784_ = _e485;
                                    } else {
                                        phi_784_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e542 = phi_784_;
                                    if ((((((_e467.member[0] <= _e472.member_2[0]) && (_e472.member[0] <= _e467.member_2[0])) && (_e467.member[1] <= _e472.member_2[1])) && (_e472.member[1] <= _e467.member_2[1])) && (_e467.member[2] <= _e472.member_2[2])) && (_e472.member[2] <= _e467.member_2[2])) {
                                        phi_813_ = _e488;
                                    } else {
                                        phi_813_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e567 = phi_813_;
                                    if ((((((_e467.member[0] <= _e477.member_2[0]) && (_e477.member[0] <= _e467.member_2[0])) && (_e467.member[1] <= _e477.member_2[1])) && (_e477.member[1] <= _e467.member_2[1])) && (_e467.member[2] <= _e477.member_2[2])) && (_e477.member[2] <= _e467.member_2[2])) {
                                        phi_842_ = _e491;
                                    } else {
                                        phi_842_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e592 = phi_842_;
                                    phi_844_ = type_23(array<array<u32, 2>, 4>(_e482, _e485, _e488, _e491), array<array<u32, 2>, 4>(_e517, _e542, _e567, _e592));
                                    phi_845_ = false;
                                } else {
                                    phi_844_ = type_23();
                                    phi_845_ = true;
                                }
                                let _e596 = phi_844_;
                                let _e598 = phi_845_;
                                phi_846_ = _e596;
                                phi_847_ = _e598;
                            } else {
                                phi_846_ = type_23();
                                phi_847_ = true;
                            }
                            let _e600 = phi_846_;
                            let _e602 = phi_847_;
                            if _e602 {
                                if _e459 {
                                    let _e711 = a_nodes.member[_e302.member_1];
                                    let _e716 = a_nodes.member[_e302.member_3];
                                    let _e720 = array<u32, 2>(_e302.member_1, _e268[1]);
                                    let _e722 = array<u32, 2>(_e302.member_3, _e268[1]);
                                    let _e729 = type_23(array<array<u32, 2>, 4>(_e720, type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e736 = type_23(array<array<u32, 2>, 4>(_e729.member[0], _e722, _e729.member[2], _e729.member[3]), _e729.member_1);
                                    let _e746 = type_23(array<array<u32, 2>, 4>(_e720, _e722, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_23(array<array<u32, 2>, 4>(_e736.member[0], _e736.member[1], array<u32, 2>(4294967295u, 4294967295u), _e736.member[3]), _e736.member_1).member_1);
                                    if ((((((_e711.member[0] <= _e304.member_2[0]) && (_e304.member[0] <= _e711.member_2[0])) && (_e711.member[1] <= _e304.member_2[1])) && (_e304.member[1] <= _e711.member_2[1])) && (_e711.member[2] <= _e304.member_2[2])) && (_e304.member[2] <= _e711.member_2[2])) {
                                        phi_920_ = _e720;
                                    } else {
                                        phi_920_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e773 = phi_920_;
                                    let _e780 = type_23(_e746.member, array<array<u32, 2>, 4>(_e773, _e746.member_1[1], _e746.member_1[2], _e746.member_1[3]));
                                    if ((((((_e716.member[0] <= _e304.member_2[0]) && (_e304.member[0] <= _e716.member_2[0])) && (_e716.member[1] <= _e304.member_2[1])) && (_e304.member[1] <= _e716.member_2[1])) && (_e716.member[2] <= _e304.member_2[2])) && (_e304.member[2] <= _e716.member_2[2])) {
                                        phi_952_ = _e722;
                                    } else {
                                        phi_952_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e807 = phi_952_;
                                    phi_1054_ = type_23(_e780.member, array<array<u32, 2>, 4>(_e780.member_1[0], _e807, _e780.member_1[2], _e780.member_1[3]));
                                } else {
                                    let _e605 = b_nodes.member[_e304.member_1];
                                    let _e610 = b_nodes.member[_e304.member_3];
                                    let _e614 = array<u32, 2>(_e268[0], _e304.member_1);
                                    let _e616 = array<u32, 2>(_e268[0], _e304.member_3);
                                    let _e623 = type_23(array<array<u32, 2>, 4>(_e614, type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    let _e630 = type_23(array<array<u32, 2>, 4>(_e623.member[0], _e616, _e623.member[2], _e623.member[3]), _e623.member_1);
                                    let _e640 = type_23(array<array<u32, 2>, 4>(_e614, _e616, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_23(array<array<u32, 2>, 4>(_e630.member[0], _e630.member[1], array<u32, 2>(4294967295u, 4294967295u), _e630.member[3]), _e630.member_1).member_1);
                                    if ((((((_e302.member[0] <= _e605.member_2[0]) && (_e605.member[0] <= _e302.member_2[0])) && (_e302.member[1] <= _e605.member_2[1])) && (_e605.member[1] <= _e302.member_2[1])) && (_e302.member[2] <= _e605.member_2[2])) && (_e605.member[2] <= _e302.member_2[2])) {
                                        phi_1020_ = _e614;
                                    } else {
                                        phi_1020_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e667 = phi_1020_;
                                    let _e674 = type_23(_e640.member, array<array<u32, 2>, 4>(_e667, _e640.member_1[1], _e640.member_1[2], _e640.member_1[3]));
                                    if ((((((_e302.member[0] <= _e610.member_2[0]) && (_e610.member[0] <= _e302.member_2[0])) && (_e302.member[1] <= _e610.member_2[1])) && (_e610.member[1] <= _e302.member_2[1])) && (_e302.member[2] <= _e610.member_2[2])) && (_e610.member[2] <= _e302.member_2[2])) {
                                        phi_1052_ = _e616;
                                    } else {
                                        phi_1052_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e701 = phi_1052_;
                                    phi_1054_ = type_23(_e674.member, array<array<u32, 2>, 4>(_e674.member_1[0], _e701, _e674.member_1[2], _e674.member_1[3]));
                                }
                                let _e816 = phi_1054_;
                                phi_1055_ = _e816;
                            } else {
                                phi_1055_ = _e600;
                            }
                            let _e818 = phi_1055_;
                            phi_1056_ = _e818;
                            phi_1057_ = false;
                        } else {
                            phi_1056_ = type_23();
                            phi_1057_ = true;
                        }
                        let _e820 = phi_1056_;
                        let _e822 = phi_1057_;
                        phi_1058_ = _e820;
                        phi_1059_ = type_23(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1060_ = _e822;
                    } else {
                        phi_1058_ = type_23();
                        phi_1059_ = _e408;
                        phi_1060_ = true;
                    }
                    let _e824 = phi_1058_;
                    let _e826 = phi_1059_;
                    let _e828 = phi_1060_;
                    if _e828 {
                        phi_1064_ = _e826;
                    } else {
                        phi_1064_ = _e824;
                    }
                    let _e830 = phi_1064_;
                    let _e834 = params.member.member_2.member_4;
                    if (_e834 > 0u) {
                        phi_1074_ = _e830.member;
                    } else {
                        phi_1074_ = _e830.member_1;
                    }
                    let _e838 = phi_1074_;
                    if (_e830.member_1[0][0] == 4294967295u) {
                        phi_1098_ = 0u;
                    } else {
                        if (_e830.member_1[0][0] >= _e285) {
                            if (_e830.member_1[0][1] >= _e290) {
                                phi_1092_ = false;
                            } else {
                                phi_1092_ = true;
                            }
                            let _e848 = phi_1092_;
                            phi_1093_ = _e848;
                        } else {
                            phi_1093_ = true;
                        }
                        let _e850 = phi_1093_;
                        if _e850 {
                            phi_1097_ = 1u;
                        } else {
                            phi_1097_ = 2u;
                        }
                        let _e852 = phi_1097_;
                        phi_1098_ = _e852;
                    }
                    let _e854 = phi_1098_;
                    let _e855 = type_25(_e830.member_1[0], _e854);
                    if (_e854 == 0u) {
                        if (_e838[0][0] != 4294967295u) {
                            phi_1110_ = type_25(_e838[0], 3u);
                        } else {
                            phi_1110_ = _e855;
                        }
                        let _e861 = phi_1110_;
                        phi_1111_ = _e861;
                    } else {
                        phi_1111_ = _e855;
                    }
                    let _e863 = phi_1111_;
                    if (_e830.member_1[1][0] == 4294967295u) {
                        phi_1135_ = 0u;
                    } else {
                        if (_e830.member_1[1][0] >= _e285) {
                            if (_e830.member_1[1][1] >= _e290) {
                                phi_1129_ = false;
                            } else {
                                phi_1129_ = true;
                            }
                            let _e873 = phi_1129_;
                            phi_1130_ = _e873;
                        } else {
                            phi_1130_ = true;
                        }
                        let _e875 = phi_1130_;
                        if _e875 {
                            phi_1134_ = 1u;
                        } else {
                            phi_1134_ = 2u;
                        }
                        let _e877 = phi_1134_;
                        phi_1135_ = _e877;
                    }
                    let _e879 = phi_1135_;
                    let _e880 = type_25(_e830.member_1[1], _e879);
                    if (_e879 == 0u) {
                        if (_e838[1][0] != 4294967295u) {
                            phi_1147_ = type_25(_e838[1], 3u);
                        } else {
                            phi_1147_ = _e880;
                        }
                        let _e886 = phi_1147_;
                        phi_1148_ = _e886;
                    } else {
                        phi_1148_ = _e880;
                    }
                    let _e888 = phi_1148_;
                    if (_e830.member_1[2][0] == 4294967295u) {
                        phi_1172_ = 0u;
                    } else {
                        if (_e830.member_1[2][0] >= _e285) {
                            if (_e830.member_1[2][1] >= _e290) {
                                phi_1166_ = false;
                            } else {
                                phi_1166_ = true;
                            }
                            let _e898 = phi_1166_;
                            phi_1167_ = _e898;
                        } else {
                            phi_1167_ = true;
                        }
                        let _e900 = phi_1167_;
                        if _e900 {
                            phi_1171_ = 1u;
                        } else {
                            phi_1171_ = 2u;
                        }
                        let _e902 = phi_1171_;
                        phi_1172_ = _e902;
                    }
                    let _e904 = phi_1172_;
                    let _e905 = type_25(_e830.member_1[2], _e904);
                    if (_e904 == 0u) {
                        if (_e838[2][0] != 4294967295u) {
                            phi_1184_ = type_25(_e838[2], 3u);
                        } else {
                            phi_1184_ = _e905;
                        }
                        let _e911 = phi_1184_;
                        phi_1185_ = _e911;
                    } else {
                        phi_1185_ = _e905;
                    }
                    let _e913 = phi_1185_;
                    if (_e830.member_1[3][0] == 4294967295u) {
                        phi_1209_ = 0u;
                    } else {
                        if (_e830.member_1[3][0] >= _e285) {
                            if (_e830.member_1[3][1] >= _e290) {
                                phi_1203_ = false;
                            } else {
                                phi_1203_ = true;
                            }
                            let _e923 = phi_1203_;
                            phi_1204_ = _e923;
                        } else {
                            phi_1204_ = true;
                        }
                        let _e925 = phi_1204_;
                        if _e925 {
                            phi_1208_ = 1u;
                        } else {
                            phi_1208_ = 2u;
                        }
                        let _e927 = phi_1208_;
                        phi_1209_ = _e927;
                    }
                    let _e929 = phi_1209_;
                    let _e930 = type_25(_e830.member_1[3], _e929);
                    if (_e929 == 0u) {
                        if (_e838[3][0] != 4294967295u) {
                            phi_1221_ = type_25(_e838[3], 3u);
                        } else {
                            phi_1221_ = _e930;
                        }
                        let _e936 = phi_1221_;
                        phi_1222_ = _e936;
                    } else {
                        phi_1222_ = _e930;
                    }
                    let _e938 = phi_1222_;
                    if (_e268[0] == 4294967295u) {
                        phi_1244_ = 0u;
                    } else {
                        if (_e268[0] >= _e285) {
                            if (_e268[1] >= _e290) {
                                phi_1238_ = false;
                            } else {
                                phi_1238_ = true;
                            }
                            let _e946 = phi_1238_;
                            phi_1239_ = _e946;
                        } else {
                            phi_1239_ = true;
                        }
                        let _e948 = phi_1239_;
                        if _e948 {
                            phi_1243_ = 1u;
                        } else {
                            phi_1243_ = 2u;
                        }
                        let _e950 = phi_1243_;
                        phi_1244_ = _e950;
                    }
                    let _e952 = phi_1244_;
                    if (_e952 == 2u) {
                        phi_1250_ = type_25(_e268, 2u);
                    } else {
                        phi_1250_ = _e863;
                    }
                    let _e956 = phi_1250_;
                    phi_1251_ = _e956;
                    phi_1252_ = _e938;
                    phi_1253_ = _e913;
                    phi_1254_ = _e888;
                } else {
                    phi_1251_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1252_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1253_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1254_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e958 = phi_1251_;
                let _e960 = phi_1252_;
                let _e962 = phi_1253_;
                let _e964 = phi_1254_;
                if (_e958.member_1 == 1u) {
                    let _e975 = atomicAdd((&shared_[6u]), 1u);
                    phi_1274_ = array<u32, 2>(_e975, 0u);
                } else {
                    if (_e958.member_1 == 2u) {
                        let _e970 = atomicAdd((&shared_[7u]), 1u);
                        phi_1273_ = array<u32, 2>(_e970, 0u);
                    } else {
                        phi_1273_ = array<u32, 2>(0u, 0u);
                    }
                    let _e973 = phi_1273_;
                    phi_1274_ = _e973;
                }
                let _e978 = phi_1274_;
                if (_e958.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e982 = atomicAdd((&shared_[8u]), 1u);
                        phi_1286_ = array<u32, 2>(_e978[0], _e982);
                    } else {
                        phi_1286_ = _e978;
                    }
                    let _e986 = phi_1286_;
                    phi_1287_ = _e986;
                } else {
                    phi_1287_ = _e978;
                }
                let _e988 = phi_1287_;
                if (_e964.member_1 == 1u) {
                    let _e998 = atomicAdd((&shared_[6u]), 1u);
                    phi_1305_ = array<u32, 2>(_e998, 0u);
                } else {
                    if (_e964.member_1 == 2u) {
                        let _e993 = atomicAdd((&shared_[7u]), 1u);
                        phi_1304_ = array<u32, 2>(_e993, 0u);
                    } else {
                        phi_1304_ = array<u32, 2>(0u, 0u);
                    }
                    let _e996 = phi_1304_;
                    phi_1305_ = _e996;
                }
                let _e1001 = phi_1305_;
                if (_e964.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e1005 = atomicAdd((&shared_[8u]), 1u);
                        phi_1317_ = array<u32, 2>(_e1001[0], _e1005);
                    } else {
                        phi_1317_ = _e1001;
                    }
                    let _e1009 = phi_1317_;
                    phi_1318_ = _e1009;
                } else {
                    phi_1318_ = _e1001;
                }
                let _e1011 = phi_1318_;
                if (_e962.member_1 == 1u) {
                    let _e1021 = atomicAdd((&shared_[6u]), 1u);
                    phi_1336_ = array<u32, 2>(_e1021, 0u);
                } else {
                    if (_e962.member_1 == 2u) {
                        let _e1016 = atomicAdd((&shared_[7u]), 1u);
                        phi_1335_ = array<u32, 2>(_e1016, 0u);
                    } else {
                        phi_1335_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1019 = phi_1335_;
                    phi_1336_ = _e1019;
                }
                let _e1024 = phi_1336_;
                if (_e962.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e1028 = atomicAdd((&shared_[8u]), 1u);
                        phi_1348_ = array<u32, 2>(_e1024[0], _e1028);
                    } else {
                        phi_1348_ = _e1024;
                    }
                    let _e1032 = phi_1348_;
                    phi_1349_ = _e1032;
                } else {
                    phi_1349_ = _e1024;
                }
                let _e1034 = phi_1349_;
                if (_e960.member_1 == 1u) {
                    let _e1044 = atomicAdd((&shared_[6u]), 1u);
                    phi_1367_ = array<u32, 2>(_e1044, 0u);
                } else {
                    if (_e960.member_1 == 2u) {
                        let _e1039 = atomicAdd((&shared_[7u]), 1u);
                        phi_1366_ = array<u32, 2>(_e1039, 0u);
                    } else {
                        phi_1366_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1042 = phi_1366_;
                    phi_1367_ = _e1042;
                }
                let _e1047 = phi_1367_;
                if (_e960.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e1051 = atomicAdd((&shared_[8u]), 1u);
                        phi_1379_ = array<u32, 2>(_e1047[0], _e1051);
                    } else {
                        phi_1379_ = _e1047;
                    }
                    let _e1055 = phi_1379_;
                    phi_1380_ = _e1055;
                } else {
                    phi_1380_ = _e1047;
                }
                let _e1057 = phi_1380_;
                workgroupBarrier();
                if (_e56 == 0u) {
                    let _e1060 = atomicLoad((&shared_[6u]));
                    let _e1062 = atomicLoad((&shared_[7u]));
                    let _e1064 = atomicLoad((&shared_[8u]));
                    let _e1066 = atomicLoad((&shared_[1u]));
                    let _e1068 = atomicLoad((&shared_[2u]));
                    let _e1070 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e1070 + 1u));
                    let _e1074 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e1074 + _e1066) + _e1068));
                    let _e1079 = atomicLoad((&shared_[0u]));
                    let _e1080 = (_e1079 - _e1066);
                    let _e1082 = (_e70.member_10 - _e1080);
                    if (_e1082 < _e1060) {
                        phi_1413_ = _e1082;
                    } else {
                        phi_1413_ = _e1060;
                    }
                    let _e1085 = phi_1413_;
                    atomicStore((&shared_[9u]), _e1080);
                    atomicStore((&shared_[10u]), _e1085);
                    atomicStore((&shared_[0u]), (_e1080 + _e1085));
                    if (_e1060 > _e1085) {
                        let _e1091 = (_e1060 - _e1085);
                        if (_e70.member_12 == 0u) {
                        } else {
                            let _e1095 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1098 = atomicAdd((&control.member[(_e73 + 1u)]), _e1091);
                        let _e1101 = atomicMax((&nodes.member[0u]), (_e1098 + _e1091));
                        if ((_e1098 + _e1091) < _e1098) {
                            let _e1105 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e1098);
                    }
                    if (_e1062 > 0u) {
                        let _e1109 = atomicAdd((&pairs.member[0u]), _e1062);
                        if ((_e1109 + _e1062) < _e1109) {
                            let _e1113 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e1109);
                    }
                    if (_e1064 > 0u) {
                        let _e1117 = atomicAdd((&control.member[1537u]), _e1064);
                        if ((_e1117 + _e1064) < _e1117) {
                            let _e1121 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e1117);
                    }
                }
                workgroupBarrier();
                if (_e958.member_1 == 1u) {
                    let _e1179 = atomicLoad((&shared_[10u]));
                    if (_e988[0] < _e1179) {
                        let _e1199 = atomicLoad((&shared_[9u]));
                        let _e1202 = (2u * (_e1199 + _e988[0]));
                        stack[_e1202] = _e958.member[0];
                        stack[(_e1202 + 1u)] = _e958.member[1];
                    } else {
                        let _e1183 = atomicLoad((&shared_[11u]));
                        let _e1186 = ((_e1183 + _e988[0]) - _e1179);
                        if (_e1186 < _e70.member_3) {
                            let _e1189 = (_e84 + _e1186);
                            if (_e1189 < 4294967295u) {
                                let _e1193 = (2u * _e1189);
                                atomicStore((&nodes.member[(4u + _e1193)]), _e958.member[0]);
                                atomicStore((&nodes.member[(_e1193 + 5u)]), _e958.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e958.member_1 == 0u) {
                    } else {
                        if (_e958.member_1 == 2u) {
                            let _e1132 = a_nodes.member[_e958.member[0]];
                            let _e1136 = b_nodes.member[_e958.member[1]];
                            if (_e70.member == 1u) {
                                if (_e1132.member_1 < _e1136.member_1) {
                                    phi_1573_ = type_9(_e1132.member_1, _e1136.member_1);
                                } else {
                                    phi_1573_ = type_9(_e1136.member_1, _e1132.member_1);
                                }
                                let _e1145 = phi_1573_;
                                phi_1578_ = _e1145;
                            } else {
                                phi_1578_ = type_9(_e1132.member_1, _e1136.member_1);
                            }
                            let _e1147 = phi_1578_;
                            let _e1151 = atomicLoad((&shared_[12u]));
                            let _e1153 = (_e1151 + _e988[0]);
                            if (_e1153 < _e86) {
                                let _e1155 = (2u * _e1153);
                                atomicStore((&pairs.member[(4u + _e1155)]), _e1147.member);
                                atomicStore((&pairs.member[(_e1155 + 5u)]), _e1147.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1163 = atomicLoad((&shared_[13u]));
                            let _e1165 = (_e1163 + _e988[1]);
                            if (_e1165 < _e70.member_4) {
                                let _e1172 = (2u * ((_e70.member_5 * _e70.member_4) + _e1165));
                                front.member[_e1172] = _e958.member[0];
                                front.member[(_e1172 + 1u)] = _e958.member[1];
                            }
                        }
                    }
                }
                if (_e964.member_1 == 1u) {
                    let _e1264 = atomicLoad((&shared_[10u]));
                    if (_e1011[0] < _e1264) {
                        let _e1284 = atomicLoad((&shared_[9u]));
                        let _e1287 = (2u * (_e1284 + _e1011[0]));
                        stack[_e1287] = _e964.member[0];
                        stack[(_e1287 + 1u)] = _e964.member[1];
                    } else {
                        let _e1268 = atomicLoad((&shared_[11u]));
                        let _e1271 = ((_e1268 + _e1011[0]) - _e1264);
                        if (_e1271 < _e70.member_3) {
                            let _e1274 = (_e84 + _e1271);
                            if (_e1274 < 4294967295u) {
                                let _e1278 = (2u * _e1274);
                                atomicStore((&nodes.member[(4u + _e1278)]), _e964.member[0]);
                                atomicStore((&nodes.member[(_e1278 + 5u)]), _e964.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e964.member_1 == 0u) {
                    } else {
                        if (_e964.member_1 == 2u) {
                            let _e1217 = a_nodes.member[_e964.member[0]];
                            let _e1221 = b_nodes.member[_e964.member[1]];
                            if (_e70.member == 1u) {
                                if (_e1217.member_1 < _e1221.member_1) {
                                    phi_1714_ = type_9(_e1217.member_1, _e1221.member_1);
                                } else {
                                    phi_1714_ = type_9(_e1221.member_1, _e1217.member_1);
                                }
                                let _e1230 = phi_1714_;
                                phi_1719_ = _e1230;
                            } else {
                                phi_1719_ = type_9(_e1217.member_1, _e1221.member_1);
                            }
                            let _e1232 = phi_1719_;
                            let _e1236 = atomicLoad((&shared_[12u]));
                            let _e1238 = (_e1236 + _e1011[0]);
                            if (_e1238 < _e86) {
                                let _e1240 = (2u * _e1238);
                                atomicStore((&pairs.member[(4u + _e1240)]), _e1232.member);
                                atomicStore((&pairs.member[(_e1240 + 5u)]), _e1232.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1248 = atomicLoad((&shared_[13u]));
                            let _e1250 = (_e1248 + _e1011[1]);
                            if (_e1250 < _e70.member_4) {
                                let _e1257 = (2u * ((_e70.member_5 * _e70.member_4) + _e1250));
                                front.member[_e1257] = _e964.member[0];
                                front.member[(_e1257 + 1u)] = _e964.member[1];
                            }
                        }
                    }
                }
                if (_e962.member_1 == 1u) {
                    let _e1349 = atomicLoad((&shared_[10u]));
                    if (_e1034[0] < _e1349) {
                        let _e1369 = atomicLoad((&shared_[9u]));
                        let _e1372 = (2u * (_e1369 + _e1034[0]));
                        stack[_e1372] = _e962.member[0];
                        stack[(_e1372 + 1u)] = _e962.member[1];
                    } else {
                        let _e1353 = atomicLoad((&shared_[11u]));
                        let _e1356 = ((_e1353 + _e1034[0]) - _e1349);
                        if (_e1356 < _e70.member_3) {
                            let _e1359 = (_e84 + _e1356);
                            if (_e1359 < 4294967295u) {
                                let _e1363 = (2u * _e1359);
                                atomicStore((&nodes.member[(4u + _e1363)]), _e962.member[0]);
                                atomicStore((&nodes.member[(_e1363 + 5u)]), _e962.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e962.member_1 == 0u) {
                    } else {
                        if (_e962.member_1 == 2u) {
                            let _e1302 = a_nodes.member[_e962.member[0]];
                            let _e1306 = b_nodes.member[_e962.member[1]];
                            if (_e70.member == 1u) {
                                if (_e1302.member_1 < _e1306.member_1) {
                                    phi_1855_ = type_9(_e1302.member_1, _e1306.member_1);
                                } else {
                                    phi_1855_ = type_9(_e1306.member_1, _e1302.member_1);
                                }
                                let _e1315 = phi_1855_;
                                phi_1860_ = _e1315;
                            } else {
                                phi_1860_ = type_9(_e1302.member_1, _e1306.member_1);
                            }
                            let _e1317 = phi_1860_;
                            let _e1321 = atomicLoad((&shared_[12u]));
                            let _e1323 = (_e1321 + _e1034[0]);
                            if (_e1323 < _e86) {
                                let _e1325 = (2u * _e1323);
                                atomicStore((&pairs.member[(4u + _e1325)]), _e1317.member);
                                atomicStore((&pairs.member[(_e1325 + 5u)]), _e1317.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1333 = atomicLoad((&shared_[13u]));
                            let _e1335 = (_e1333 + _e1034[1]);
                            if (_e1335 < _e70.member_4) {
                                let _e1342 = (2u * ((_e70.member_5 * _e70.member_4) + _e1335));
                                front.member[_e1342] = _e962.member[0];
                                front.member[(_e1342 + 1u)] = _e962.member[1];
                            }
                        }
                    }
                }
                if (_e960.member_1 == 1u) {
                    let _e1434 = atomicLoad((&shared_[10u]));
                    if (_e1057[0] < _e1434) {
                        let _e1454 = atomicLoad((&shared_[9u]));
                        let _e1457 = (2u * (_e1454 + _e1057[0]));
                        stack[_e1457] = _e960.member[0];
                        stack[(_e1457 + 1u)] = _e960.member[1];
                    } else {
                        let _e1438 = atomicLoad((&shared_[11u]));
                        let _e1441 = ((_e1438 + _e1057[0]) - _e1434);
                        if (_e1441 < _e70.member_3) {
                            let _e1444 = (_e84 + _e1441);
                            if (_e1444 < 4294967295u) {
                                let _e1448 = (2u * _e1444);
                                atomicStore((&nodes.member[(4u + _e1448)]), _e960.member[0]);
                                atomicStore((&nodes.member[(_e1448 + 5u)]), _e960.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e960.member_1 == 0u) {
                    } else {
                        if (_e960.member_1 == 2u) {
                            let _e1387 = a_nodes.member[_e960.member[0]];
                            let _e1391 = b_nodes.member[_e960.member[1]];
                            if (_e70.member == 1u) {
                                if (_e1387.member_1 < _e1391.member_1) {
                                    phi_1996_ = type_9(_e1387.member_1, _e1391.member_1);
                                } else {
                                    phi_1996_ = type_9(_e1391.member_1, _e1387.member_1);
                                }
                                let _e1400 = phi_1996_;
                                phi_2001_ = _e1400;
                            } else {
                                phi_2001_ = type_9(_e1387.member_1, _e1391.member_1);
                            }
                            let _e1402 = phi_2001_;
                            let _e1406 = atomicLoad((&shared_[12u]));
                            let _e1408 = (_e1406 + _e1057[0]);
                            if (_e1408 < _e86) {
                                let _e1410 = (2u * _e1408);
                                atomicStore((&pairs.member[(4u + _e1410)]), _e1402.member);
                                atomicStore((&pairs.member[(_e1410 + 5u)]), _e1402.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1418 = atomicLoad((&shared_[13u]));
                            let _e1420 = (_e1418 + _e1057[1]);
                            if (_e1420 < _e70.member_4) {
                                let _e1427 = (2u * ((_e70.member_5 * _e70.member_4) + _e1420));
                                front.member[_e1427] = _e960.member[0];
                                front.member[(_e1427 + 1u)] = _e960.member[1];
                            }
                        }
                    }
                }
                phi_2045_ = true;
            }
            let _e1464 = phi_2045_;
            phi_2046_ = _e1464;
        } else {
            phi_2046_ = false;
        }
        let _e1466 = phi_2046_;
        continue;
        continuing {
            phi_161_ = _e107;
            break if !(_e1466);
        }
    }
    if (_e56 == 0u) {
        if (_e70.member_6 == 0u) {
            if (_e68 < _e81) {
                phi_2065_ = ((((_e81 - 1u) - _e68) >> bitcast<u32>((_e70.member_7 & 31u))) + 1u);
            } else {
                phi_2065_ = 0u;
            }
            let _e1479 = phi_2065_;
            let _e1481 = atomicLoad((&shared_[5u]));
            phi_2069_ = (_e1479 - _e1481);
        } else {
            phi_2069_ = 0u;
        }
        let _e1484 = phi_2069_;
        atomicStore((&shared_[14u]), _e1484);
        let _e1487 = atomicLoad((&shared_[0u]));
        let _e1488 = (_e1487 + _e1484);
        if (_e1488 > 0u) {
            if (_e70.member_12 == 0u) {
            } else {
                let _e1493 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e1496 = atomicAdd((&control.member[(_e73 + 1u)]), _e1488);
            let _e1499 = atomicMax((&nodes.member[0u]), (_e1496 + _e1488));
            if ((_e1496 + _e1488) < _e1496) {
                let _e1503 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e1496);
        }
        let _e1508 = atomicLoad((&shared_[15u]));
        let _e1510 = atomicAdd((&control.member[(1540u + (2u * _e68))]), _e1508);
        let _e1514 = atomicLoad((&shared_[16u]));
        let _e1516 = atomicAdd((&control.member[((2u * _e68) + 1541u)]), _e1514);
    }
    workgroupBarrier();
    let _e1518 = atomicLoad((&shared_[0u]));
    let _e1520 = atomicLoad((&shared_[17u]));
    let _e1522 = atomicLoad((&shared_[14u]));
    phi_2126_ = type_9(0u, 8u);
    loop {
        let _e1524 = phi_2126_;
        if (_e1524.member < _e1524.member_1) {
            phi_2127_ = type_9((_e1524.member + 1u), _e1524.member_1);
            phi_2150_ = type_9(1u, _e1524.member);
        } else {
            phi_2127_ = _e1524;
            phi_2150_ = type_9(0u, type_9().member_1);
        }
        let _e1536 = phi_2127_;
        let _e1538 = phi_2150_;
        let _e1542 = (bitcast<i32>(_e1538.member) != 0i);
        if _e1542 {
            let _e1544 = ((_e1538.member_1 * 128u) + _e56);
            if (_e1544 < _e1518) {
                let _e1548 = stack[(2u * _e1544)];
                let _e1552 = stack[((2u * _e1544) + 1u)];
                let _e1553 = (_e1520 + _e1544);
                if (_e1553 < _e70.member_3) {
                    let _e1556 = (_e84 + _e1553);
                    if (_e1556 < 4294967295u) {
                        let _e1558 = (2u * _e1556);
                        atomicStore((&nodes.member[(4u + _e1558)]), _e1548);
                        atomicStore((&nodes.member[(_e1558 + 5u)]), _e1552);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2126_ = _e1536;
            break if !(_e1542);
        }
    }
    let _e1565 = atomicLoad((&shared_[5u]));
    let _e1566 = (_e1522 / 128u);
    if ((_e1522 % 128u) > 0u) {
        phi_2206_ = (_e1566 + 1u);
    } else {
        phi_2206_ = _e1566;
    }
    let _e1571 = phi_2206_;
    phi_2209_ = type_9(0u, _e1571);
    loop {
        let _e1574 = phi_2209_;
        if (_e1574.member < _e1574.member_1) {
            phi_2210_ = type_9((_e1574.member + 1u), _e1574.member_1);
            phi_2233_ = type_9(1u, _e1574.member);
        } else {
            phi_2210_ = _e1574;
            phi_2233_ = type_9(0u, type_9().member_1);
        }
        let _e1586 = phi_2210_;
        let _e1588 = phi_2233_;
        let _e1592 = (bitcast<i32>(_e1588.member) != 0i);
        if _e1592 {
            let _e1594 = ((_e1588.member_1 * 128u) + _e56);
            if (_e1594 < _e1522) {
                let _e1602 = (2u * ((_e82 + _e68) + ((_e1565 + _e1594) << bitcast<u32>((_e70.member_7 & 31u)))));
                let _e1605 = atomicLoad((&nodes.member[(4u + _e1602)]));
                let _e1608 = atomicLoad((&nodes.member[(_e1602 + 5u)]));
                let _e1610 = ((_e1520 + _e1518) + _e1594);
                if (_e1610 < _e70.member_3) {
                    let _e1613 = (_e84 + _e1610);
                    if (_e1613 < 4294967295u) {
                        let _e1615 = (2u * _e1613);
                        atomicStore((&nodes.member[(4u + _e1615)]), _e1605);
                        atomicStore((&nodes.member[(_e1615 + 5u)]), _e1608);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2209_ = _e1586;
            break if !(_e1592);
        }
    }
    if (_e70.member_6 == 1u) {
        if (_e1565 == 0u) {
            phi_2305_ = type_9(0u, _e81);
            loop {
                let _e1626 = phi_2305_;
                if (_e1626.member < _e1626.member_1) {
                    phi_2306_ = type_9((_e1626.member + 1u), _e1626.member_1);
                    phi_2329_ = type_9(1u, _e1626.member);
                } else {
                    phi_2306_ = _e1626;
                    phi_2329_ = type_9(0u, type_9().member_1);
                }
                let _e1638 = phi_2306_;
                let _e1640 = phi_2329_;
                if (bitcast<i32>(_e1640.member) != 0i) {
                    let _e1646 = atomicAdd((&control.member[(512u + _e73)]), 1u);
                    if (_e1646 >= _e81) {
                        phi_2409_ = false;
                    } else {
                        let _e1649 = (2u * (_e82 + _e1646));
                        let _e1652 = atomicLoad((&nodes.member[(4u + _e1649)]));
                        let _e1655 = atomicLoad((&nodes.member[(_e1649 + 5u)]));
                        if (_e70.member_12 == 0u) {
                        } else {
                            let _e1659 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1662 = atomicAdd((&control.member[(_e73 + 1u)]), 1u);
                        let _e1665 = atomicMax((&nodes.member[0u]), (_e1662 + 1u));
                        if ((_e1662 + 1u) < _e1662) {
                            let _e1669 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1662 < _e70.member_3) {
                            let _e1672 = (_e84 + _e1662);
                            if (_e1672 < 4294967295u) {
                                let _e1674 = (2u * _e1672);
                                atomicStore((&nodes.member[(4u + _e1674)]), _e1652);
                                atomicStore((&nodes.member[(_e1674 + 5u)]), _e1655);
                            }
                        }
                        phi_2409_ = true;
                    }
                    let _e1680 = phi_2409_;
                    phi_2410_ = _e1680;
                } else {
                    phi_2410_ = false;
                }
                let _e1682 = phi_2410_;
                continue;
                continuing {
                    phi_2305_ = _e1638;
                    break if !(_e1682);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn pair_workers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
