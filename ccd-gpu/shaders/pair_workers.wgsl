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
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
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

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_25 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_26 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_27 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: array<u32, 2>,
    member_3: array<u32, 2>,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_30;
@group(0) @binding(1) 
var<storage> a: type_19;
@group(0) @binding(2) 
var<storage> b: type_19;
@group(0) @binding(3) 
var<storage, read_write> control: type_30;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_30;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
var<workgroup> sums: array<u32, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_174_: u32;
    var phi_212_: type_9;
    var phi_213_: type_9;
    var phi_236_: type_9;
    var phi_260_: u32;
    var phi_291_: bool;
    var phi_295_: u32;
    var phi_296_: u32;
    var phi_297_: u32;
    var phi_395_: u32;
    var phi_400_: u32;
    var phi_405_: u32;
    var phi_418_: u32;
    var phi_424_: u32;
    var phi_433_: u32;
    var phi_362_: u32;
    var phi_368_: u32;
    var phi_374_: u32;
    var phi_434_: u32;
    var phi_325_: u32;
    var phi_331_: u32;
    var phi_435_: u32;
    var phi_436_: u32;
    var phi_437_: u32;
    var phi_457_: u32;
    var phi_458_: u32;
    var phi_541_: array<u32, 2>;
    var phi_542_: array<u32, 2>;
    var phi_559_: array<u32, 2>;
    var phi_588_: u32;
    var phi_662_: array<u32, 2>;
    var phi_676_: array<u32, 2>;
    var phi_713_: array<u32, 2>;
    var phi_715_: type_25;
    var phi_716_: type_25;
    var phi_717_: bool;
    var phi_718_: type_25;
    var phi_719_: bool;
    var phi_735_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_890_: array<u32, 2>;
    var phi_919_: array<u32, 2>;
    var phi_948_: array<u32, 2>;
    var phi_977_: array<u32, 2>;
    var phi_979_: type_25;
    var phi_980_: bool;
    var phi_981_: type_25;
    var phi_982_: bool;
    var phi_1155_: array<u32, 2>;
    var phi_1187_: array<u32, 2>;
    var phi_1055_: array<u32, 2>;
    var phi_1087_: array<u32, 2>;
    var phi_1189_: type_25;
    var phi_1190_: type_25;
    var phi_1191_: type_25;
    var phi_1192_: bool;
    var phi_1193_: type_25;
    var phi_1194_: type_25;
    var phi_1195_: bool;
    var phi_1199_: type_25;
    var phi_1210_: array<array<u32, 2>, 4>;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1233_: u32;
    var phi_1234_: u32;
    var phi_1246_: type_26;
    var phi_1247_: type_26;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1270_: u32;
    var phi_1271_: u32;
    var phi_1283_: type_26;
    var phi_1284_: type_26;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1307_: u32;
    var phi_1308_: u32;
    var phi_1320_: type_26;
    var phi_1321_: type_26;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1344_: u32;
    var phi_1345_: u32;
    var phi_1357_: type_26;
    var phi_1358_: type_26;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1379_: u32;
    var phi_1380_: u32;
    var phi_1386_: type_26;
    var phi_1387_: type_26;
    var phi_1388_: type_26;
    var phi_1389_: type_26;
    var phi_1390_: type_26;
    var phi_1710_: u32;
    var phi_1720_: array<u32, 3>;
    var phi_1729_: array<u32, 3>;
    var phi_1738_: array<u32, 3>;
    var phi_1746_: u32;
    var phi_1771_: u32;
    var phi_1790_: u32;
    var phi_1809_: u32;
    var phi_1449_: u32;
    var phi_1456_: type_9;
    var phi_1459_: u32;
    var phi_1461_: u32;
    var phi_1463_: u32;
    var phi_1460_: u32;
    var phi_1457_: type_9;
    var phi_1486_: type_9;
    var phi_1502_: u32;
    var phi_1462_: u32;
    var phi_1464_: u32;
    var local: u32;
    var phi_1529_: type_9;
    var phi_1532_: u32;
    var phi_1534_: u32;
    var phi_1536_: u32;
    var phi_1533_: u32;
    var phi_1530_: type_9;
    var phi_1559_: type_9;
    var phi_1575_: u32;
    var phi_1535_: u32;
    var phi_1537_: u32;
    var local_1: u32;
    var phi_1589_: u32;
    var phi_1597_: u32;
    var phi_1616_: u32;
    var phi_1635_: u32;
    var phi_1654_: u32;
    var phi_1812_: type_27;
    var phi_1856_: u32;
    var phi_2042_: type_9;
    var phi_2047_: type_9;
    var phi_2206_: type_9;
    var phi_2211_: type_9;
    var phi_2370_: type_9;
    var phi_2375_: type_9;
    var phi_2534_: type_9;
    var phi_2539_: type_9;
    var phi_2592_: bool;
    var phi_2593_: bool;
    var phi_2616_: u32;
    var phi_2621_: u32;
    var phi_2647_: u32;
    var phi_2653_: u32;
    var phi_2741_: type_9;
    var phi_2742_: type_9;
    var phi_2765_: type_9;
    var phi_2856_: u32;
    var phi_2859_: type_9;
    var phi_2860_: type_9;
    var phi_2883_: type_9;
    var phi_2964_: type_9;
    var phi_2965_: type_9;
    var phi_2988_: type_9;
    var phi_3080_: bool;
    var phi_3081_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e61 = id_2;
    let _e62 = n_2;
    let _e63 = lane_2;
    let _e75 = ((_e61.y * _e62.x) + _e61.x);
    let _e77 = params.member.member_2;
    let _e79 = params.member.member_1;
    let _e82 = (_e79.member_1 % 2u);
    let _e84 = atomicLoad((&control.member[_e79.member_1]));
    if (_e77.member_3 < _e84) {
        phi_174_ = _e77.member_3;
    } else {
        phi_174_ = _e84;
    }
    let _e87 = phi_174_;
    let _e88 = (_e82 * _e77.member_3);
    let _e90 = ((1u - _e82) * _e77.member_3);
    if (_e63 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_212_ = type_9(0u, _e77.member_12);
    loop {
        let _e99 = phi_212_;
        if (_e99.member < _e99.member_1) {
            phi_213_ = type_9((_e99.member + 1u), _e99.member_1);
            phi_236_ = type_9(1u, _e99.member);
        } else {
            phi_213_ = _e99;
            phi_236_ = type_9(0u, type_9().member_1);
        }
        let _e111 = phi_213_;
        let _e113 = phi_236_;
        if (bitcast<i32>(_e113.member) != 0i) {
            if (_e63 == 0u) {
                let _e124 = atomicLoad((&shared_[0u]));
                if (128u < _e124) {
                    phi_260_ = 128u;
                } else {
                    phi_260_ = _e124;
                }
                let _e127 = phi_260_;
                if (_e77.member_9 > 0u) {
                    if (_e113.member_1 >= 16u) {
                        let _e132 = atomicLoad((&control.member[(1024u + _e79.member_1)]));
                        if (_e77.member_9 > 0u) {
                            phi_291_ = ((_e132 * 100u) >= (_e77.member_9 << bitcast<u32>((_e77.member_7 & 31u))));
                        } else {
                            phi_291_ = false;
                        }
                        let _e140 = phi_291_;
                        if _e140 {
                            phi_295_ = 2u;
                        } else {
                            phi_295_ = 0u;
                        }
                        let _e142 = phi_295_;
                        phi_296_ = _e142;
                    } else {
                        phi_296_ = 0u;
                    }
                    let _e144 = phi_296_;
                    phi_297_ = _e144;
                } else {
                    phi_297_ = 0u;
                }
                let _e146 = phi_297_;
                let _e147 = (128u - _e127);
                if (_e146 == 0u) {
                    if (_e147 > 0u) {
                        let _e151 = atomicLoad((&shared_[5u]));
                        if (_e77.member_6 == 0u) {
                            if (_e75 < _e87) {
                                phi_325_ = ((((_e87 - 1u) - _e75) >> bitcast<u32>((_e77.member_7 & 31u))) + 1u);
                            } else {
                                phi_325_ = 0u;
                            }
                            let _e220 = phi_325_;
                            let _e221 = (_e220 - _e151);
                            if (_e147 < _e221) {
                                phi_331_ = _e147;
                            } else {
                                phi_331_ = _e221;
                            }
                            let _e224 = phi_331_;
                            atomicStore((&shared_[3u]), (_e75 + (_e151 << bitcast<u32>((_e77.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e77.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e151 + _e224));
                            phi_435_ = _e224;
                        } else {
                            if (_e77.member_6 == 2u) {
                                let _e192 = (((_e87 + (1u << bitcast<u32>((_e77.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e77.member_7 & 31u)));
                                let _e193 = (_e75 * _e192);
                                if (_e87 < _e193) {
                                    phi_362_ = _e87;
                                } else {
                                    phi_362_ = _e193;
                                }
                                let _e196 = phi_362_;
                                let _e197 = (_e87 - _e196);
                                if (_e197 < _e192) {
                                    phi_368_ = _e197;
                                } else {
                                    phi_368_ = _e192;
                                }
                                let _e200 = phi_368_;
                                let _e201 = (_e200 - _e151);
                                if (_e147 < _e201) {
                                    phi_374_ = _e147;
                                } else {
                                    phi_374_ = _e201;
                                }
                                let _e204 = phi_374_;
                                atomicStore((&shared_[3u]), (_e196 + _e151));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e151 + _e204));
                                phi_434_ = _e204;
                            } else {
                                if (_e151 == 0u) {
                                    let _e158 = (_e87 >> bitcast<u32>(((_e77.member_7 + 2u) & 31u)));
                                    if (_e77.member_8 < _e158) {
                                        phi_395_ = _e158;
                                    } else {
                                        phi_395_ = _e77.member_8;
                                    }
                                    let _e161 = phi_395_;
                                    if (128u < _e161) {
                                        phi_400_ = 128u;
                                    } else {
                                        phi_400_ = _e161;
                                    }
                                    let _e164 = phi_400_;
                                    if (_e147 < _e164) {
                                        phi_405_ = _e147;
                                    } else {
                                        phi_405_ = _e164;
                                    }
                                    let _e167 = phi_405_;
                                    let _e170 = atomicAdd((&control.member[(512u + _e79.member_1)]), _e167);
                                    if (_e87 < _e170) {
                                        phi_418_ = _e87;
                                    } else {
                                        phi_418_ = _e170;
                                    }
                                    let _e173 = phi_418_;
                                    let _e174 = (_e87 - _e173);
                                    if (_e167 < _e174) {
                                        phi_424_ = _e167;
                                    } else {
                                        phi_424_ = _e174;
                                    }
                                    let _e177 = phi_424_;
                                    atomicStore((&shared_[3u]), _e170);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e177 < _e167)));
                                    phi_433_ = _e177;
                                } else {
                                    phi_433_ = 0u;
                                }
                                let _e184 = phi_433_;
                                phi_434_ = _e184;
                            }
                            let _e211 = phi_434_;
                            phi_435_ = _e211;
                        }
                        let _e237 = phi_435_;
                        phi_436_ = _e237;
                    } else {
                        phi_436_ = 0u;
                    }
                    let _e239 = phi_436_;
                    phi_437_ = _e239;
                } else {
                    phi_437_ = 0u;
                }
                let _e241 = phi_437_;
                if (_e146 == 0u) {
                    if ((_e127 + _e241) == 0u) {
                        if (_e77.member_9 > 0u) {
                            let _e248 = atomicAdd((&control.member[(1024u + _e79.member_1)]), 1u);
                        }
                        phi_457_ = 1u;
                    } else {
                        phi_457_ = _e146;
                    }
                    let _e250 = phi_457_;
                    phi_458_ = _e250;
                } else {
                    phi_458_ = _e146;
                }
                let _e252 = phi_458_;
                atomicStore((&shared_[1u]), _e127);
                atomicStore((&shared_[2u]), _e241);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e252;
            }
            let _e260 = workgroupUniformLoad((&state[0u]));
            if (_e260 != 0u) {
                phi_2592_ = false;
            } else {
                let _e263 = atomicLoad((&shared_[1u]));
                let _e265 = atomicLoad((&shared_[2u]));
                if (_e63 < _e263) {
                    let _e288 = atomicLoad((&shared_[0u]));
                    let _e291 = (2u * ((_e288 - 1u) - _e63));
                    let _e293 = stack[_e291];
                    let _e296 = stack[(_e291 + 1u)];
                    phi_542_ = array<u32, 2>(_e293, _e296);
                } else {
                    if (_e63 < (_e263 + _e265)) {
                        let _e270 = atomicLoad((&shared_[3u]));
                        let _e273 = atomicLoad((&shared_[4u]));
                        let _e277 = (2u * (_e88 + (_e270 + ((_e63 - _e263) * _e273))));
                        let _e280 = atomicLoad((&nodes.member[(4u + _e277)]));
                        let _e283 = atomicLoad((&nodes.member[(_e277 + 5u)]));
                        phi_541_ = array<u32, 2>(_e280, _e283);
                    } else {
                        phi_541_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e286 = phi_541_;
                    phi_542_ = _e286;
                }
                let _e299 = phi_542_;
                let _e302 = params.member.member_2.member;
                let _e306 = params.member.member_2.member;
                if (_e306 == 0u) {
                    phi_559_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_559_ = array<u32, 2>(1u, 1u);
                }
                let _e309 = phi_559_;
                let _e315 = params.member.member.member[_e309[0]];
                let _e316 = (_e315 - 1u);
                let _e320 = params.member.member.member[_e309[1]];
                let _e321 = (_e320 - 1u);
                let _e324 = params.member.member_2.member_1;
                if (_e324 == 0u) {
                    phi_588_ = 1u;
                } else {
                    phi_588_ = 0u;
                }
                let _e327 = phi_588_;
                if (_e299[0] != 4294967295u) {
                    let _e333 = a.member[_e299[0]];
                    let _e335 = b.member[_e299[1]];
                    if (_e302 == 1u) {
                        if (_e299[0] == _e299[1]) {
                            if (_e333.member_3 == 4294967295u) {
                                phi_715_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e341 = a.member[_e333.member_1];
                                let _e344 = a.member[_e333.member_3];
                                if !((_e341.member_3 == 4294967295u)) {
                                    phi_662_ = array<u32, 2>(_e333.member_1, _e333.member_1);
                                } else {
                                    phi_662_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e351 = phi_662_;
                                let _e358 = type_25(array<array<u32, 2>, 4>(_e351, type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e370 = type_25(array<array<u32, 2>, 4>(_e358.member[0], array<u32, 2>(_e333.member_1, _e358.member[1][1]), _e358.member[2], _e358.member[3]), _e358.member_1);
                                let _e371 = array<u32, 2>(_e333.member_1, _e333.member_3);
                                let _e378 = type_25(array<array<u32, 2>, 4>(_e370.member[0], _e371, _e370.member[2], _e370.member[3]), _e370.member_1);
                                if !((_e344.member_3 == 4294967295u)) {
                                    phi_676_ = array<u32, 2>(_e333.member_3, _e333.member_3);
                                } else {
                                    phi_676_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e385 = phi_676_;
                                let _e392 = type_25(array<array<u32, 2>, 4>(_e378.member[0], _e378.member[1], _e385, _e378.member[3]), _e378.member_1);
                                let _e395 = type_25(_e392.member, _e392.member);
                                if ((((((_e341.member[0] <= _e344.member_2[0]) && (_e344.member[0] <= _e341.member_2[0])) && (_e341.member[1] <= _e344.member_2[1])) && (_e344.member[1] <= _e341.member_2[1])) && (_e341.member[2] <= _e344.member_2[2])) && (_e344.member[2] <= _e341.member_2[2])) {
                                    phi_713_ = _e371;
                                } else {
                                    phi_713_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e424 = phi_713_;
                                phi_715_ = type_25(_e395.member, array<array<u32, 2>, 4>(_e395.member_1[0], _e424, _e395.member_1[2], _e395.member_1[3]));
                            }
                            let _e433 = phi_715_;
                            phi_716_ = _e433;
                            phi_717_ = false;
                        } else {
                            phi_716_ = type_25();
                            phi_717_ = true;
                        }
                        let _e435 = phi_716_;
                        let _e437 = phi_717_;
                        phi_718_ = _e435;
                        phi_719_ = _e437;
                    } else {
                        phi_718_ = type_25();
                        phi_719_ = true;
                    }
                    let _e439 = phi_718_;
                    let _e441 = phi_719_;
                    if _e441 {
                        let _e444 = !((_e333.member_3 == 4294967295u));
                        let _e447 = !((_e335.member_3 == 4294967295u));
                        if _e444 {
                            phi_735_ = true;
                        } else {
                            phi_735_ = _e447;
                        }
                        let _e449 = phi_735_;
                        if _e449 {
                            if _e444 {
                                if _e447 {
                                    if (_e327 == 0u) {
                                        let _e477 = ((((_e335.member_2[0] - _e335.member[0]) * (_e335.member_2[1] - _e335.member[1])) * (_e335.member_2[2] - _e335.member[2])) > (((_e333.member_2[0] - _e333.member[0]) * (_e333.member_2[1] - _e333.member[1])) * (_e333.member_2[2] - _e333.member[2])));
                                        phi_779_ = _e477;
                                        phi_780_ = !(_e477);
                                    } else {
                                        phi_779_ = _e447;
                                        phi_780_ = _e444;
                                    }
                                    let _e480 = phi_779_;
                                    let _e482 = phi_780_;
                                    phi_781_ = _e480;
                                    phi_782_ = _e482;
                                } else {
                                    phi_781_ = _e447;
                                    phi_782_ = _e444;
                                }
                                let _e484 = phi_781_;
                                let _e486 = phi_782_;
                                phi_783_ = _e484;
                                phi_784_ = _e486;
                            } else {
                                phi_783_ = _e447;
                                phi_784_ = _e444;
                            }
                            let _e488 = phi_783_;
                            let _e490 = phi_784_;
                            if _e490 {
                                if _e488 {
                                    let _e493 = a.member[_e333.member_1];
                                    let _e498 = a.member[_e333.member_3];
                                    let _e503 = b.member[_e335.member_1];
                                    let _e508 = b.member[_e335.member_3];
                                    let _e513 = array<u32, 2>(_e333.member_1, _e335.member_1);
                                    let _e516 = array<u32, 2>(_e333.member_1, _e335.member_3);
                                    let _e519 = array<u32, 2>(_e333.member_3, _e335.member_1);
                                    let _e522 = array<u32, 2>(_e333.member_3, _e335.member_3);
                                    if ((((((_e493.member[0] <= _e503.member_2[0]) && (_e503.member[0] <= _e493.member_2[0])) && (_e493.member[1] <= _e503.member_2[1])) && (_e503.member[1] <= _e493.member_2[1])) && (_e493.member[2] <= _e503.member_2[2])) && (_e503.member[2] <= _e493.member_2[2])) {
                                        phi_890_ = _e513;
                                    } else {
                                        phi_890_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e548 = phi_890_;
                                    if ((((((_e493.member[0] <= _e508.member_2[0]) && (_e508.member[0] <= _e493.member_2[0])) && (_e493.member[1] <= _e508.member_2[1])) && (_e508.member[1] <= _e493.member_2[1])) && (_e493.member[2] <= _e508.member_2[2])) && (_e508.member[2] <= _e493.member_2[2])) {
                                        phi_919_ = _e516;
                                    } else {
                                        phi_919_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e573 = phi_919_;
                                    if ((((((_e498.member[0] <= _e503.member_2[0]) && (_e503.member[0] <= _e498.member_2[0])) && (_e498.member[1] <= _e503.member_2[1])) && (_e503.member[1] <= _e498.member_2[1])) && (_e498.member[2] <= _e503.member_2[2])) && (_e503.member[2] <= _e498.member_2[2])) {
                                        phi_948_ = _e519;
                                    } else {
                                        phi_948_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e598 = phi_948_;
                                    if ((((((_e498.member[0] <= _e508.member_2[0]) && (_e508.member[0] <= _e498.member_2[0])) && (_e498.member[1] <= _e508.member_2[1])) && (_e508.member[1] <= _e498.member_2[1])) && (_e498.member[2] <= _e508.member_2[2])) && (_e508.member[2] <= _e498.member_2[2])) {
                                        phi_977_ = _e522;
                                    } else {
                                        phi_977_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e623 = phi_977_;
                                    phi_979_ = type_25(array<array<u32, 2>, 4>(_e513, _e516, _e519, _e522), array<array<u32, 2>, 4>(_e548, _e573, _e598, _e623));
                                    phi_980_ = false;
                                } else {
                                    phi_979_ = type_25();
                                    phi_980_ = true;
                                }
                                let _e627 = phi_979_;
                                let _e629 = phi_980_;
                                phi_981_ = _e627;
                                phi_982_ = _e629;
                            } else {
                                phi_981_ = type_25();
                                phi_982_ = true;
                            }
                            let _e631 = phi_981_;
                            let _e633 = phi_982_;
                            if _e633 {
                                if _e490 {
                                    let _e721 = a.member[_e333.member_1];
                                    let _e726 = a.member[_e333.member_3];
                                    let _e730 = array<u32, 2>(_e333.member_1, _e299[1]);
                                    let _e732 = array<u32, 2>(_e333.member_3, _e299[1]);
                                    let _e735 = type_25(array<array<u32, 2>, 4>(_e730, _e732, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e721.member[0] <= _e335.member_2[0]) && (_e335.member[0] <= _e721.member_2[0])) && (_e721.member[1] <= _e335.member_2[1])) && (_e335.member[1] <= _e721.member_2[1])) && (_e721.member[2] <= _e335.member_2[2])) && (_e335.member[2] <= _e721.member_2[2])) {
                                        phi_1055_ = _e730;
                                    } else {
                                        phi_1055_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e762 = phi_1055_;
                                    let _e769 = type_25(_e735.member, array<array<u32, 2>, 4>(_e762, _e735.member_1[1], _e735.member_1[2], _e735.member_1[3]));
                                    if ((((((_e726.member[0] <= _e335.member_2[0]) && (_e335.member[0] <= _e726.member_2[0])) && (_e726.member[1] <= _e335.member_2[1])) && (_e335.member[1] <= _e726.member_2[1])) && (_e726.member[2] <= _e335.member_2[2])) && (_e335.member[2] <= _e726.member_2[2])) {
                                        phi_1087_ = _e732;
                                    } else {
                                        phi_1087_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e796 = phi_1087_;
                                    phi_1189_ = type_25(_e769.member, array<array<u32, 2>, 4>(_e769.member_1[0], _e796, _e769.member_1[2], _e769.member_1[3]));
                                } else {
                                    let _e636 = b.member[_e335.member_1];
                                    let _e641 = b.member[_e335.member_3];
                                    let _e645 = array<u32, 2>(_e299[0], _e335.member_1);
                                    let _e647 = array<u32, 2>(_e299[0], _e335.member_3);
                                    let _e650 = type_25(array<array<u32, 2>, 4>(_e645, _e647, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e333.member[0] <= _e636.member_2[0]) && (_e636.member[0] <= _e333.member_2[0])) && (_e333.member[1] <= _e636.member_2[1])) && (_e636.member[1] <= _e333.member_2[1])) && (_e333.member[2] <= _e636.member_2[2])) && (_e636.member[2] <= _e333.member_2[2])) {
                                        phi_1155_ = _e645;
                                    } else {
                                        phi_1155_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e677 = phi_1155_;
                                    let _e684 = type_25(_e650.member, array<array<u32, 2>, 4>(_e677, _e650.member_1[1], _e650.member_1[2], _e650.member_1[3]));
                                    if ((((((_e333.member[0] <= _e641.member_2[0]) && (_e641.member[0] <= _e333.member_2[0])) && (_e333.member[1] <= _e641.member_2[1])) && (_e641.member[1] <= _e333.member_2[1])) && (_e333.member[2] <= _e641.member_2[2])) && (_e641.member[2] <= _e333.member_2[2])) {
                                        phi_1187_ = _e647;
                                    } else {
                                        phi_1187_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e711 = phi_1187_;
                                    phi_1189_ = type_25(_e684.member, array<array<u32, 2>, 4>(_e684.member_1[0], _e711, _e684.member_1[2], _e684.member_1[3]));
                                }
                                let _e805 = phi_1189_;
                                phi_1190_ = _e805;
                            } else {
                                phi_1190_ = _e631;
                            }
                            let _e807 = phi_1190_;
                            phi_1191_ = _e807;
                            phi_1192_ = false;
                        } else {
                            phi_1191_ = type_25();
                            phi_1192_ = true;
                        }
                        let _e809 = phi_1191_;
                        let _e811 = phi_1192_;
                        phi_1193_ = _e809;
                        phi_1194_ = type_25(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1195_ = _e811;
                    } else {
                        phi_1193_ = type_25();
                        phi_1194_ = _e439;
                        phi_1195_ = true;
                    }
                    let _e813 = phi_1193_;
                    let _e815 = phi_1194_;
                    let _e817 = phi_1195_;
                    if _e817 {
                        phi_1199_ = _e815;
                    } else {
                        phi_1199_ = _e813;
                    }
                    let _e819 = phi_1199_;
                    let _e823 = params.member.member_2.member_4;
                    if (_e823 > 0u) {
                        phi_1210_ = _e819.member;
                    } else {
                        phi_1210_ = _e819.member_1;
                    }
                    let _e827 = phi_1210_;
                    if (_e819.member_1[0][0] == 4294967295u) {
                        phi_1234_ = 0u;
                    } else {
                        if (_e819.member_1[0][0] >= _e316) {
                            if (_e819.member_1[0][1] >= _e321) {
                                phi_1228_ = false;
                            } else {
                                phi_1228_ = true;
                            }
                            let _e837 = phi_1228_;
                            phi_1229_ = _e837;
                        } else {
                            phi_1229_ = true;
                        }
                        let _e839 = phi_1229_;
                        if _e839 {
                            phi_1233_ = 1u;
                        } else {
                            phi_1233_ = 2u;
                        }
                        let _e841 = phi_1233_;
                        phi_1234_ = _e841;
                    }
                    let _e843 = phi_1234_;
                    let _e844 = type_26(_e819.member_1[0], _e843);
                    if (_e843 == 0u) {
                        if (_e827[0][0] != 4294967295u) {
                            phi_1246_ = type_26(_e827[0], 3u);
                        } else {
                            phi_1246_ = _e844;
                        }
                        let _e850 = phi_1246_;
                        phi_1247_ = _e850;
                    } else {
                        phi_1247_ = _e844;
                    }
                    let _e852 = phi_1247_;
                    if (_e819.member_1[1][0] == 4294967295u) {
                        phi_1271_ = 0u;
                    } else {
                        if (_e819.member_1[1][0] >= _e316) {
                            if (_e819.member_1[1][1] >= _e321) {
                                phi_1265_ = false;
                            } else {
                                phi_1265_ = true;
                            }
                            let _e862 = phi_1265_;
                            phi_1266_ = _e862;
                        } else {
                            phi_1266_ = true;
                        }
                        let _e864 = phi_1266_;
                        if _e864 {
                            phi_1270_ = 1u;
                        } else {
                            phi_1270_ = 2u;
                        }
                        let _e866 = phi_1270_;
                        phi_1271_ = _e866;
                    }
                    let _e868 = phi_1271_;
                    let _e869 = type_26(_e819.member_1[1], _e868);
                    if (_e868 == 0u) {
                        if (_e827[1][0] != 4294967295u) {
                            phi_1283_ = type_26(_e827[1], 3u);
                        } else {
                            phi_1283_ = _e869;
                        }
                        let _e875 = phi_1283_;
                        phi_1284_ = _e875;
                    } else {
                        phi_1284_ = _e869;
                    }
                    let _e877 = phi_1284_;
                    if (_e819.member_1[2][0] == 4294967295u) {
                        phi_1308_ = 0u;
                    } else {
                        if (_e819.member_1[2][0] >= _e316) {
                            if (_e819.member_1[2][1] >= _e321) {
                                phi_1302_ = false;
                            } else {
                                phi_1302_ = true;
                            }
                            let _e887 = phi_1302_;
                            phi_1303_ = _e887;
                        } else {
                            phi_1303_ = true;
                        }
                        let _e889 = phi_1303_;
                        if _e889 {
                            phi_1307_ = 1u;
                        } else {
                            phi_1307_ = 2u;
                        }
                        let _e891 = phi_1307_;
                        phi_1308_ = _e891;
                    }
                    let _e893 = phi_1308_;
                    let _e894 = type_26(_e819.member_1[2], _e893);
                    if (_e893 == 0u) {
                        if (_e827[2][0] != 4294967295u) {
                            phi_1320_ = type_26(_e827[2], 3u);
                        } else {
                            phi_1320_ = _e894;
                        }
                        let _e900 = phi_1320_;
                        phi_1321_ = _e900;
                    } else {
                        phi_1321_ = _e894;
                    }
                    let _e902 = phi_1321_;
                    if (_e819.member_1[3][0] == 4294967295u) {
                        phi_1345_ = 0u;
                    } else {
                        if (_e819.member_1[3][0] >= _e316) {
                            if (_e819.member_1[3][1] >= _e321) {
                                phi_1339_ = false;
                            } else {
                                phi_1339_ = true;
                            }
                            let _e912 = phi_1339_;
                            phi_1340_ = _e912;
                        } else {
                            phi_1340_ = true;
                        }
                        let _e914 = phi_1340_;
                        if _e914 {
                            phi_1344_ = 1u;
                        } else {
                            phi_1344_ = 2u;
                        }
                        let _e916 = phi_1344_;
                        phi_1345_ = _e916;
                    }
                    let _e918 = phi_1345_;
                    let _e919 = type_26(_e819.member_1[3], _e918);
                    if (_e918 == 0u) {
                        if (_e827[3][0] != 4294967295u) {
                            phi_1357_ = type_26(_e827[3], 3u);
                        } else {
                            phi_1357_ = _e919;
                        }
                        let _e925 = phi_1357_;
                        phi_1358_ = _e925;
                    } else {
                        phi_1358_ = _e919;
                    }
                    let _e927 = phi_1358_;
                    if (_e299[0] == 4294967295u) {
                        phi_1380_ = 0u;
                    } else {
                        if (_e299[0] >= _e316) {
                            if (_e299[1] >= _e321) {
                                phi_1374_ = false;
                            } else {
                                phi_1374_ = true;
                            }
                            let _e935 = phi_1374_;
                            phi_1375_ = _e935;
                        } else {
                            phi_1375_ = true;
                        }
                        let _e937 = phi_1375_;
                        if _e937 {
                            phi_1379_ = 1u;
                        } else {
                            phi_1379_ = 2u;
                        }
                        let _e939 = phi_1379_;
                        phi_1380_ = _e939;
                    }
                    let _e941 = phi_1380_;
                    if (_e941 == 2u) {
                        phi_1386_ = type_26(_e299, 2u);
                    } else {
                        phi_1386_ = _e852;
                    }
                    let _e945 = phi_1386_;
                    phi_1387_ = _e945;
                    phi_1388_ = _e927;
                    phi_1389_ = _e902;
                    phi_1390_ = _e877;
                } else {
                    phi_1387_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1388_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1389_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1390_ = type_26(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e947 = phi_1387_;
                let _e949 = phi_1388_;
                let _e951 = phi_1389_;
                let _e953 = phi_1390_;
                if (_e77.member_11 == 1u) {
                    if (_e77.member_4 > 0u) {
                        phi_1449_ = (((select(0u, 1u, (_e947.member_1 >= 2u)) + select(0u, 1u, (_e953.member_1 >= 2u))) + select(0u, 1u, (_e951.member_1 >= 2u))) + select(0u, 1u, (_e949.member_1 >= 2u)));
                    } else {
                        phi_1449_ = 0u;
                    }
                    let _e1138 = phi_1449_;
                    let _e1141 = ((((select(0u, 1u, (_e947.member_1 == 1u)) + select(0u, 1u, (_e953.member_1 == 1u))) + select(0u, 1u, (_e951.member_1 == 1u))) + select(0u, 1u, (_e949.member_1 == 1u))) | ((((select(0u, 1u, (_e947.member_1 == 2u)) + select(0u, 1u, (_e953.member_1 == 2u))) + select(0u, 1u, (_e951.member_1 == 2u))) + select(0u, 1u, (_e949.member_1 == 2u))) << bitcast<u32>(16i)));
                    sums[_e63] = _e1141;
                    phi_1456_ = type_9(0u, 7u);
                    phi_1459_ = 0u;
                    phi_1461_ = 1u;
                    phi_1463_ = _e1141;
                    phi_1460_ = 128u;
                    loop {
                        let _e1144 = phi_1456_;
                        let _e1146 = phi_1459_;
                        let _e1148 = phi_1461_;
                        let _e1150 = phi_1463_;
                        let _e1152 = phi_1460_;
                        local = _e1150;
                        if (_e1144.member < _e1144.member_1) {
                            phi_1457_ = type_9((_e1144.member + 1u), _e1144.member_1);
                            phi_1486_ = type_9(1u, _e1144.member);
                        } else {
                            phi_1457_ = _e1144;
                            phi_1486_ = type_9(0u, type_9().member_1);
                        }
                        let _e1164 = phi_1457_;
                        let _e1166 = phi_1486_;
                        let _e1169 = (bitcast<i32>(_e1166.member) != 0i);
                        if _e1169 {
                            workgroupBarrier();
                            if (_e63 >= _e1148) {
                                let _e1174 = sums[((_e1146 + _e63) - _e1148)];
                                phi_1502_ = (_e1150 + _e1174);
                            } else {
                                phi_1502_ = _e1150;
                            }
                            let _e1177 = phi_1502_;
                            sums[(_e1152 + _e63)] = _e1177;
                            phi_1462_ = (_e1148 * 2u);
                            phi_1464_ = _e1177;
                        } else {
                            phi_1462_ = u32();
                            phi_1464_ = u32();
                        }
                        let _e1182 = phi_1462_;
                        let _e1184 = phi_1464_;
                        continue;
                        continuing {
                            phi_1456_ = _e1164;
                            phi_1459_ = _e1152;
                            phi_1461_ = _e1182;
                            phi_1463_ = _e1184;
                            phi_1460_ = _e1146;
                            break if !(_e1169);
                        }
                    }
                    workgroupBarrier();
                    let _e1187 = local;
                    let _e1188 = (_e1187 - _e1141);
                    if (_e63 == 0u) {
                        let _e1191 = sums[255u];
                        atomicStore((&shared_[6u]), (_e1191 & 65535u));
                        atomicStore((&shared_[7u]), (_e1191 >> bitcast<u32>(16i)));
                    }
                    if (_e77.member_4 > 0u) {
                        sums[_e63] = _e1138;
                        phi_1529_ = type_9(0u, 7u);
                        phi_1532_ = 0u;
                        phi_1534_ = 1u;
                        phi_1536_ = _e1138;
                        phi_1533_ = 128u;
                        loop {
                            let _e1201 = phi_1529_;
                            let _e1203 = phi_1532_;
                            let _e1205 = phi_1534_;
                            let _e1207 = phi_1536_;
                            let _e1209 = phi_1533_;
                            local_1 = _e1207;
                            if (_e1201.member < _e1201.member_1) {
                                phi_1530_ = type_9((_e1201.member + 1u), _e1201.member_1);
                                phi_1559_ = type_9(1u, _e1201.member);
                            } else {
                                phi_1530_ = _e1201;
                                phi_1559_ = type_9(0u, type_9().member_1);
                            }
                            let _e1221 = phi_1530_;
                            let _e1223 = phi_1559_;
                            let _e1226 = (bitcast<i32>(_e1223.member) != 0i);
                            if _e1226 {
                                workgroupBarrier();
                                if (_e63 >= _e1205) {
                                    let _e1231 = sums[((_e1203 + _e63) - _e1205)];
                                    phi_1575_ = (_e1207 + _e1231);
                                } else {
                                    phi_1575_ = _e1207;
                                }
                                let _e1234 = phi_1575_;
                                sums[(_e1209 + _e63)] = _e1234;
                                phi_1535_ = (_e1205 * 2u);
                                phi_1537_ = _e1234;
                            } else {
                                phi_1535_ = u32();
                                phi_1537_ = u32();
                            }
                            let _e1239 = phi_1535_;
                            let _e1241 = phi_1537_;
                            continue;
                            continuing {
                                phi_1529_ = _e1221;
                                phi_1532_ = _e1209;
                                phi_1534_ = _e1239;
                                phi_1536_ = _e1241;
                                phi_1533_ = _e1203;
                                break if !(_e1226);
                            }
                        }
                        workgroupBarrier();
                        let _e1244 = local_1;
                        if (_e63 == 0u) {
                            let _e1248 = sums[255u];
                            atomicStore((&shared_[8u]), _e1248);
                        }
                        phi_1589_ = (_e1244 - _e1138);
                    } else {
                        phi_1589_ = 0u;
                    }
                    let _e1251 = phi_1589_;
                    let _e1252 = (_e1188 & 65535u);
                    let _e1254 = (_e1188 >> bitcast<u32>(16i));
                    if (_e947.member_1 == 1u) {
                        phi_1597_ = _e1252;
                    } else {
                        phi_1597_ = _e1254;
                    }
                    let _e1258 = phi_1597_;
                    let _e1263 = (_e1252 + select(0u, 1u, (_e947.member_1 == 1u)));
                    let _e1267 = (_e1254 + select(0u, 1u, (_e947.member_1 == 2u)));
                    let _e1271 = (_e1251 + select(0u, 1u, (_e947.member_1 >= 2u)));
                    if (_e953.member_1 == 1u) {
                        phi_1616_ = _e1263;
                    } else {
                        phi_1616_ = _e1267;
                    }
                    let _e1275 = phi_1616_;
                    let _e1280 = (_e1263 + select(0u, 1u, (_e953.member_1 == 1u)));
                    let _e1284 = (_e1267 + select(0u, 1u, (_e953.member_1 == 2u)));
                    let _e1288 = (_e1271 + select(0u, 1u, (_e953.member_1 >= 2u)));
                    if (_e951.member_1 == 1u) {
                        phi_1635_ = _e1280;
                    } else {
                        phi_1635_ = _e1284;
                    }
                    let _e1292 = phi_1635_;
                    if (_e949.member_1 == 1u) {
                        phi_1654_ = (_e1280 + select(0u, 1u, (_e951.member_1 == 1u)));
                    } else {
                        phi_1654_ = (_e1284 + select(0u, 1u, (_e951.member_1 == 2u)));
                    }
                    let _e1309 = phi_1654_;
                    phi_1812_ = type_27(array<u32, 2>(_e1258, _e1251), array<u32, 2>(_e1275, _e1271), array<u32, 2>(_e1292, _e1288), array<u32, 2>(_e1309, (_e1288 + select(0u, 1u, (_e951.member_1 >= 2u)))));
                } else {
                    let _e993 = (((select(0u, 1u, (_e947.member_1 == 1u)) + select(0u, 1u, (_e953.member_1 == 1u))) + select(0u, 1u, (_e951.member_1 == 1u))) + select(0u, 1u, (_e949.member_1 == 1u)));
                    let _e997 = (((select(0u, 1u, (_e947.member_1 == 2u)) + select(0u, 1u, (_e953.member_1 == 2u))) + select(0u, 1u, (_e951.member_1 == 2u))) + select(0u, 1u, (_e949.member_1 == 2u)));
                    if (_e77.member_4 > 0u) {
                        phi_1710_ = (((select(0u, 1u, (_e947.member_1 >= 2u)) + select(0u, 1u, (_e953.member_1 >= 2u))) + select(0u, 1u, (_e951.member_1 >= 2u))) + select(0u, 1u, (_e949.member_1 >= 2u)));
                    } else {
                        phi_1710_ = 0u;
                    }
                    let _e1004 = phi_1710_;
                    if (_e993 > 0u) {
                        let _e1007 = atomicAdd((&shared_[6u]), _e993);
                        phi_1720_ = array<u32, 3>(_e1007, 0u, 0u);
                    } else {
                        phi_1720_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e1010 = phi_1720_;
                    if (_e997 > 0u) {
                        let _e1013 = atomicAdd((&shared_[7u]), _e997);
                        phi_1729_ = array<u32, 3>(_e1010[0], _e1013, _e1010[2]);
                    } else {
                        phi_1729_ = _e1010;
                    }
                    let _e1018 = phi_1729_;
                    if (_e1004 > 0u) {
                        let _e1021 = atomicAdd((&shared_[8u]), _e1004);
                        phi_1738_ = array<u32, 3>(_e1018[0], _e1018[1], _e1021);
                    } else {
                        phi_1738_ = _e1018;
                    }
                    let _e1026 = phi_1738_;
                    if (_e947.member_1 == 1u) {
                        phi_1746_ = _e1026[0];
                    } else {
                        phi_1746_ = _e1026[1];
                    }
                    let _e1032 = phi_1746_;
                    let _e1039 = (_e1026[0] + select(0u, 1u, (_e947.member_1 == 1u)));
                    let _e1044 = (_e1026[1] + select(0u, 1u, (_e947.member_1 == 2u)));
                    let _e1049 = (_e1026[2] + select(0u, 1u, (_e947.member_1 >= 2u)));
                    if (_e953.member_1 == 1u) {
                        phi_1771_ = _e1039;
                    } else {
                        phi_1771_ = _e1044;
                    }
                    let _e1053 = phi_1771_;
                    let _e1058 = (_e1039 + select(0u, 1u, (_e953.member_1 == 1u)));
                    let _e1062 = (_e1044 + select(0u, 1u, (_e953.member_1 == 2u)));
                    let _e1066 = (_e1049 + select(0u, 1u, (_e953.member_1 >= 2u)));
                    if (_e951.member_1 == 1u) {
                        phi_1790_ = _e1058;
                    } else {
                        phi_1790_ = _e1062;
                    }
                    let _e1070 = phi_1790_;
                    if (_e949.member_1 == 1u) {
                        phi_1809_ = (_e1058 + select(0u, 1u, (_e951.member_1 == 1u)));
                    } else {
                        phi_1809_ = (_e1062 + select(0u, 1u, (_e951.member_1 == 2u)));
                    }
                    let _e1087 = phi_1809_;
                    phi_1812_ = type_27(array<u32, 2>(_e1032, _e1026[2]), array<u32, 2>(_e1053, _e1049), array<u32, 2>(_e1070, _e1066), array<u32, 2>(_e1087, (_e1066 + select(0u, 1u, (_e951.member_1 >= 2u)))));
                }
                let _e1313 = phi_1812_;
                workgroupBarrier();
                if (_e63 == 0u) {
                    let _e1316 = atomicLoad((&shared_[6u]));
                    let _e1318 = atomicLoad((&shared_[7u]));
                    let _e1320 = atomicLoad((&shared_[8u]));
                    let _e1322 = atomicLoad((&shared_[1u]));
                    let _e1324 = atomicLoad((&shared_[2u]));
                    let _e1326 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e1326 + 1u));
                    let _e1330 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e1330 + _e1322) + _e1324));
                    let _e1335 = atomicLoad((&shared_[0u]));
                    let _e1336 = (_e1335 - _e1322);
                    let _e1338 = (_e77.member_10 - _e1336);
                    if (_e1338 < _e1316) {
                        phi_1856_ = _e1338;
                    } else {
                        phi_1856_ = _e1316;
                    }
                    let _e1341 = phi_1856_;
                    atomicStore((&shared_[9u]), _e1336);
                    atomicStore((&shared_[10u]), _e1341);
                    atomicStore((&shared_[0u]), (_e1336 + _e1341));
                    if (_e1316 > _e1341) {
                        let _e1347 = (_e1316 - _e1341);
                        if (_e77.member_13 == 0u) {
                        } else {
                            let _e1351 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1354 = atomicAdd((&control.member[(_e79.member_1 + 1u)]), _e1347);
                        let _e1357 = atomicMax((&nodes.member[0u]), (_e1354 + _e1347));
                        if ((_e1354 + _e1347) < _e1354) {
                            let _e1361 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e1354);
                    }
                    if (_e1318 > 0u) {
                        let _e1365 = atomicAdd((&pairs.member[0u]), _e1318);
                        if ((_e1365 + _e1318) < _e1365) {
                            let _e1369 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e1365);
                    }
                    if (_e1320 > 0u) {
                        let _e1373 = atomicAdd((&control.member[1537u]), _e1320);
                        if ((_e1373 + _e1320) < _e1373) {
                            let _e1377 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e1373);
                    }
                }
                workgroupBarrier();
                if (_e947.member_1 == 1u) {
                    let _e1441 = atomicLoad((&shared_[10u]));
                    if (_e1313.member[0] < _e1441) {
                        let _e1461 = atomicLoad((&shared_[9u]));
                        let _e1464 = (2u * (_e1461 + _e1313.member[0]));
                        stack[_e1464] = _e947.member[0];
                        stack[(_e1464 + 1u)] = _e947.member[1];
                    } else {
                        let _e1445 = atomicLoad((&shared_[11u]));
                        let _e1448 = ((_e1445 + _e1313.member[0]) - _e1441);
                        if (_e1448 < _e77.member_3) {
                            let _e1451 = (_e90 + _e1448);
                            if (_e1451 < 4294967295u) {
                                let _e1455 = (2u * _e1451);
                                atomicStore((&nodes.member[(4u + _e1455)]), _e947.member[0]);
                                atomicStore((&nodes.member[(_e1455 + 5u)]), _e947.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e947.member_1 == 0u) {
                    } else {
                        if (_e947.member_1 == 2u) {
                            let _e1389 = a.member[_e947.member[0]];
                            let _e1393 = b.member[_e947.member[1]];
                            let _e1397 = params.member.member_2.member;
                            if (_e1397 == 1u) {
                                if (_e1389.member_1 < _e1393.member_1) {
                                    phi_2042_ = type_9(_e1389.member_1, _e1393.member_1);
                                } else {
                                    phi_2042_ = type_9(_e1393.member_1, _e1389.member_1);
                                }
                                let _e1404 = phi_2042_;
                                phi_2047_ = _e1404;
                            } else {
                                phi_2047_ = type_9(_e1389.member_1, _e1393.member_1);
                            }
                            let _e1406 = phi_2047_;
                            let _e1410 = params.member.member_1;
                            let _e1413 = atomicLoad((&shared_[12u]));
                            let _e1415 = (_e1413 + _e1313.member[0]);
                            if (_e1415 < _e1410.member_3) {
                                let _e1417 = (2u * _e1415);
                                atomicStore((&pairs.member[(4u + _e1417)]), _e1406.member);
                                atomicStore((&pairs.member[(_e1417 + 5u)]), _e1406.member_1);
                            }
                        }
                        if (_e77.member_4 > 0u) {
                            let _e1425 = atomicLoad((&shared_[13u]));
                            let _e1427 = (_e1425 + _e1313.member[1]);
                            if (_e1427 < _e77.member_4) {
                                let _e1434 = (2u * ((_e77.member_5 * _e77.member_4) + _e1427));
                                front.member[_e1434] = _e947.member[0];
                                front.member[(_e1434 + 1u)] = _e947.member[1];
                            }
                        }
                    }
                }
                if (_e953.member_1 == 1u) {
                    let _e1532 = atomicLoad((&shared_[10u]));
                    if (_e1313.member_1[0] < _e1532) {
                        let _e1552 = atomicLoad((&shared_[9u]));
                        let _e1555 = (2u * (_e1552 + _e1313.member_1[0]));
                        stack[_e1555] = _e953.member[0];
                        stack[(_e1555 + 1u)] = _e953.member[1];
                    } else {
                        let _e1536 = atomicLoad((&shared_[11u]));
                        let _e1539 = ((_e1536 + _e1313.member_1[0]) - _e1532);
                        if (_e1539 < _e77.member_3) {
                            let _e1542 = (_e90 + _e1539);
                            if (_e1542 < 4294967295u) {
                                let _e1546 = (2u * _e1542);
                                atomicStore((&nodes.member[(4u + _e1546)]), _e953.member[0]);
                                atomicStore((&nodes.member[(_e1546 + 5u)]), _e953.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e953.member_1 == 0u) {
                    } else {
                        if (_e953.member_1 == 2u) {
                            let _e1480 = a.member[_e953.member[0]];
                            let _e1484 = b.member[_e953.member[1]];
                            let _e1488 = params.member.member_2.member;
                            if (_e1488 == 1u) {
                                if (_e1480.member_1 < _e1484.member_1) {
                                    phi_2206_ = type_9(_e1480.member_1, _e1484.member_1);
                                } else {
                                    phi_2206_ = type_9(_e1484.member_1, _e1480.member_1);
                                }
                                let _e1495 = phi_2206_;
                                phi_2211_ = _e1495;
                            } else {
                                phi_2211_ = type_9(_e1480.member_1, _e1484.member_1);
                            }
                            let _e1497 = phi_2211_;
                            let _e1501 = params.member.member_1;
                            let _e1504 = atomicLoad((&shared_[12u]));
                            let _e1506 = (_e1504 + _e1313.member_1[0]);
                            if (_e1506 < _e1501.member_3) {
                                let _e1508 = (2u * _e1506);
                                atomicStore((&pairs.member[(4u + _e1508)]), _e1497.member);
                                atomicStore((&pairs.member[(_e1508 + 5u)]), _e1497.member_1);
                            }
                        }
                        if (_e77.member_4 > 0u) {
                            let _e1516 = atomicLoad((&shared_[13u]));
                            let _e1518 = (_e1516 + _e1313.member_1[1]);
                            if (_e1518 < _e77.member_4) {
                                let _e1525 = (2u * ((_e77.member_5 * _e77.member_4) + _e1518));
                                front.member[_e1525] = _e953.member[0];
                                front.member[(_e1525 + 1u)] = _e953.member[1];
                            }
                        }
                    }
                }
                if (_e951.member_1 == 1u) {
                    let _e1623 = atomicLoad((&shared_[10u]));
                    if (_e1313.member_2[0] < _e1623) {
                        let _e1643 = atomicLoad((&shared_[9u]));
                        let _e1646 = (2u * (_e1643 + _e1313.member_2[0]));
                        stack[_e1646] = _e951.member[0];
                        stack[(_e1646 + 1u)] = _e951.member[1];
                    } else {
                        let _e1627 = atomicLoad((&shared_[11u]));
                        let _e1630 = ((_e1627 + _e1313.member_2[0]) - _e1623);
                        if (_e1630 < _e77.member_3) {
                            let _e1633 = (_e90 + _e1630);
                            if (_e1633 < 4294967295u) {
                                let _e1637 = (2u * _e1633);
                                atomicStore((&nodes.member[(4u + _e1637)]), _e951.member[0]);
                                atomicStore((&nodes.member[(_e1637 + 5u)]), _e951.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e951.member_1 == 0u) {
                    } else {
                        if (_e951.member_1 == 2u) {
                            let _e1571 = a.member[_e951.member[0]];
                            let _e1575 = b.member[_e951.member[1]];
                            let _e1579 = params.member.member_2.member;
                            if (_e1579 == 1u) {
                                if (_e1571.member_1 < _e1575.member_1) {
                                    phi_2370_ = type_9(_e1571.member_1, _e1575.member_1);
                                } else {
                                    phi_2370_ = type_9(_e1575.member_1, _e1571.member_1);
                                }
                                let _e1586 = phi_2370_;
                                phi_2375_ = _e1586;
                            } else {
                                phi_2375_ = type_9(_e1571.member_1, _e1575.member_1);
                            }
                            let _e1588 = phi_2375_;
                            let _e1592 = params.member.member_1;
                            let _e1595 = atomicLoad((&shared_[12u]));
                            let _e1597 = (_e1595 + _e1313.member_2[0]);
                            if (_e1597 < _e1592.member_3) {
                                let _e1599 = (2u * _e1597);
                                atomicStore((&pairs.member[(4u + _e1599)]), _e1588.member);
                                atomicStore((&pairs.member[(_e1599 + 5u)]), _e1588.member_1);
                            }
                        }
                        if (_e77.member_4 > 0u) {
                            let _e1607 = atomicLoad((&shared_[13u]));
                            let _e1609 = (_e1607 + _e1313.member_2[1]);
                            if (_e1609 < _e77.member_4) {
                                let _e1616 = (2u * ((_e77.member_5 * _e77.member_4) + _e1609));
                                front.member[_e1616] = _e951.member[0];
                                front.member[(_e1616 + 1u)] = _e951.member[1];
                            }
                        }
                    }
                }
                if (_e949.member_1 == 1u) {
                    let _e1714 = atomicLoad((&shared_[10u]));
                    if (_e1313.member_3[0] < _e1714) {
                        let _e1734 = atomicLoad((&shared_[9u]));
                        let _e1737 = (2u * (_e1734 + _e1313.member_3[0]));
                        stack[_e1737] = _e949.member[0];
                        stack[(_e1737 + 1u)] = _e949.member[1];
                    } else {
                        let _e1718 = atomicLoad((&shared_[11u]));
                        let _e1721 = ((_e1718 + _e1313.member_3[0]) - _e1714);
                        if (_e1721 < _e77.member_3) {
                            let _e1724 = (_e90 + _e1721);
                            if (_e1724 < 4294967295u) {
                                let _e1728 = (2u * _e1724);
                                atomicStore((&nodes.member[(4u + _e1728)]), _e949.member[0]);
                                atomicStore((&nodes.member[(_e1728 + 5u)]), _e949.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e949.member_1 == 0u) {
                    } else {
                        if (_e949.member_1 == 2u) {
                            let _e1662 = a.member[_e949.member[0]];
                            let _e1666 = b.member[_e949.member[1]];
                            let _e1670 = params.member.member_2.member;
                            if (_e1670 == 1u) {
                                if (_e1662.member_1 < _e1666.member_1) {
                                    phi_2534_ = type_9(_e1662.member_1, _e1666.member_1);
                                } else {
                                    phi_2534_ = type_9(_e1666.member_1, _e1662.member_1);
                                }
                                let _e1677 = phi_2534_;
                                phi_2539_ = _e1677;
                            } else {
                                phi_2539_ = type_9(_e1662.member_1, _e1666.member_1);
                            }
                            let _e1679 = phi_2539_;
                            let _e1683 = params.member.member_1;
                            let _e1686 = atomicLoad((&shared_[12u]));
                            let _e1688 = (_e1686 + _e1313.member_3[0]);
                            if (_e1688 < _e1683.member_3) {
                                let _e1690 = (2u * _e1688);
                                atomicStore((&pairs.member[(4u + _e1690)]), _e1679.member);
                                atomicStore((&pairs.member[(_e1690 + 5u)]), _e1679.member_1);
                            }
                        }
                        if (_e77.member_4 > 0u) {
                            let _e1698 = atomicLoad((&shared_[13u]));
                            let _e1700 = (_e1698 + _e1313.member_3[1]);
                            if (_e1700 < _e77.member_4) {
                                let _e1707 = (2u * ((_e77.member_5 * _e77.member_4) + _e1700));
                                front.member[_e1707] = _e949.member[0];
                                front.member[(_e1707 + 1u)] = _e949.member[1];
                            }
                        }
                    }
                }
                phi_2592_ = true;
            }
            let _e1744 = phi_2592_;
            phi_2593_ = _e1744;
        } else {
            phi_2593_ = false;
        }
        let _e1746 = phi_2593_;
        continue;
        continuing {
            phi_212_ = _e111;
            break if !(_e1746);
        }
    }
    if (_e63 == 0u) {
        if (_e77.member_6 == 0u) {
            if (_e75 < _e87) {
                phi_2616_ = ((((_e87 - 1u) - _e75) >> bitcast<u32>((_e77.member_7 & 31u))) + 1u);
            } else {
                phi_2616_ = 0u;
            }
            let _e1760 = phi_2616_;
            let _e1762 = atomicLoad((&shared_[5u]));
            phi_2621_ = (_e1760 - _e1762);
        } else {
            phi_2621_ = 0u;
        }
        let _e1765 = phi_2621_;
        atomicStore((&shared_[14u]), _e1765);
        let _e1768 = atomicLoad((&shared_[0u]));
        let _e1769 = (_e1768 + _e1765);
        if (_e77.member_6 == 2u) {
            let _e1796 = (((_e87 + (1u << bitcast<u32>((_e77.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e77.member_7 & 31u)));
            let _e1797 = (_e75 * _e1796);
            if (_e87 < _e1797) {
                phi_2647_ = _e87;
            } else {
                phi_2647_ = _e1797;
            }
            let _e1800 = phi_2647_;
            let _e1801 = (_e87 - _e1800);
            if (_e1801 < _e1796) {
                phi_2653_ = _e1801;
            } else {
                phi_2653_ = _e1796;
            }
            let _e1804 = phi_2653_;
            let _e1811 = ((1540u + (2u * (1u << bitcast<u32>((_e77.member_7 & 31u))))) + (2u * _e75));
            let _e1813 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e1811]), _e1813);
            let _e1817 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e1811 + 1u)]), (_e1804 - _e1817));
        } else {
            if (_e1769 > 0u) {
                if (_e77.member_13 == 0u) {
                } else {
                    let _e1776 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e1779 = atomicAdd((&control.member[(_e79.member_1 + 1u)]), _e1769);
                let _e1782 = atomicMax((&nodes.member[0u]), (_e1779 + _e1769));
                if ((_e1779 + _e1769) < _e1779) {
                    let _e1786 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e1779);
            }
        }
        let _e1823 = atomicLoad((&shared_[15u]));
        let _e1825 = atomicAdd((&control.member[(1540u + (2u * _e75))]), _e1823);
        let _e1829 = atomicLoad((&shared_[16u]));
        let _e1831 = atomicAdd((&control.member[((2u * _e75) + 1541u)]), _e1829);
    }
    workgroupBarrier();
    let _e1833 = atomicLoad((&shared_[0u]));
    let _e1835 = atomicLoad((&shared_[17u]));
    let _e1837 = atomicLoad((&shared_[14u]));
    phi_2741_ = type_9(0u, 8u);
    loop {
        let _e1839 = phi_2741_;
        if (_e1839.member < _e1839.member_1) {
            phi_2742_ = type_9((_e1839.member + 1u), _e1839.member_1);
            phi_2765_ = type_9(1u, _e1839.member);
        } else {
            phi_2742_ = _e1839;
            phi_2765_ = type_9(0u, type_9().member_1);
        }
        let _e1851 = phi_2742_;
        let _e1853 = phi_2765_;
        let _e1857 = (bitcast<i32>(_e1853.member) != 0i);
        if _e1857 {
            let _e1859 = ((_e1853.member_1 * 128u) + _e63);
            if (_e1859 < _e1833) {
                let _e1863 = stack[(2u * _e1859)];
                let _e1867 = stack[((2u * _e1859) + 1u)];
                if (_e77.member_6 == 2u) {
                    let _e1899 = ((((((1540u + (2u * (1u << bitcast<u32>((_e77.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e77.member_7 & 31u))))) + (1u << bitcast<u32>((_e77.member_7 & 31u)))) + 1u) + (_e75 * 2048u)) + (2u * _e1859));
                    atomicStore((&control.member[_e1899]), _e1863);
                    atomicStore((&control.member[(_e1899 + 1u)]), _e1867);
                } else {
                    let _e1870 = (_e1835 + _e1859);
                    if (_e1870 < _e77.member_3) {
                        let _e1873 = (_e90 + _e1870);
                        if (_e1873 < 4294967295u) {
                            let _e1875 = (2u * _e1873);
                            atomicStore((&nodes.member[(4u + _e1875)]), _e1863);
                            atomicStore((&nodes.member[(_e1875 + 5u)]), _e1867);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2741_ = _e1851;
            break if !(_e1857);
        }
    }
    let _e1905 = atomicLoad((&shared_[5u]));
    let _e1906 = (_e1837 / 128u);
    if ((_e1837 % 128u) > 0u) {
        phi_2856_ = (_e1906 + 1u);
    } else {
        phi_2856_ = _e1906;
    }
    let _e1911 = phi_2856_;
    phi_2859_ = type_9(0u, _e1911);
    loop {
        let _e1914 = phi_2859_;
        if (_e1914.member < _e1914.member_1) {
            phi_2860_ = type_9((_e1914.member + 1u), _e1914.member_1);
            phi_2883_ = type_9(1u, _e1914.member);
        } else {
            phi_2860_ = _e1914;
            phi_2883_ = type_9(0u, type_9().member_1);
        }
        let _e1926 = phi_2860_;
        let _e1928 = phi_2883_;
        let _e1932 = (bitcast<i32>(_e1928.member) != 0i);
        if _e1932 {
            let _e1934 = ((_e1928.member_1 * 128u) + _e63);
            if (_e1934 < _e1837) {
                let _e1943 = (2u * ((_e88 + _e75) + ((_e1905 + _e1934) << bitcast<u32>((_e77.member_7 & 31u)))));
                let _e1946 = atomicLoad((&nodes.member[(4u + _e1943)]));
                let _e1949 = atomicLoad((&nodes.member[(_e1943 + 5u)]));
                let _e1951 = ((_e1835 + _e1833) + _e1934);
                if (_e1951 < _e77.member_3) {
                    let _e1954 = (_e90 + _e1951);
                    if (_e1954 < 4294967295u) {
                        let _e1956 = (2u * _e1954);
                        atomicStore((&nodes.member[(4u + _e1956)]), _e1946);
                        atomicStore((&nodes.member[(_e1956 + 5u)]), _e1949);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2859_ = _e1926;
            break if !(_e1932);
        }
    }
    if (_e77.member_6 == 1u) {
        if (_e1905 == 0u) {
            phi_2964_ = type_9(0u, _e87);
            loop {
                let _e1967 = phi_2964_;
                if (_e1967.member < _e1967.member_1) {
                    phi_2965_ = type_9((_e1967.member + 1u), _e1967.member_1);
                    phi_2988_ = type_9(1u, _e1967.member);
                } else {
                    phi_2965_ = _e1967;
                    phi_2988_ = type_9(0u, type_9().member_1);
                }
                let _e1979 = phi_2965_;
                let _e1981 = phi_2988_;
                if (bitcast<i32>(_e1981.member) != 0i) {
                    let _e1987 = atomicAdd((&control.member[(512u + _e79.member_1)]), 1u);
                    if (_e1987 >= _e87) {
                        phi_3080_ = false;
                    } else {
                        let _e1990 = (2u * (_e88 + _e1987));
                        let _e1993 = atomicLoad((&nodes.member[(4u + _e1990)]));
                        let _e1996 = atomicLoad((&nodes.member[(_e1990 + 5u)]));
                        if (_e77.member_13 == 0u) {
                        } else {
                            let _e2000 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e2003 = atomicAdd((&control.member[(_e79.member_1 + 1u)]), 1u);
                        let _e2006 = atomicMax((&nodes.member[0u]), (_e2003 + 1u));
                        if ((_e2003 + 1u) < _e2003) {
                            let _e2010 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e2003 < _e77.member_3) {
                            let _e2013 = (_e90 + _e2003);
                            if (_e2013 < 4294967295u) {
                                let _e2015 = (2u * _e2013);
                                atomicStore((&nodes.member[(4u + _e2015)]), _e1993);
                                atomicStore((&nodes.member[(_e2015 + 5u)]), _e1996);
                            }
                        }
                        phi_3080_ = true;
                    }
                    let _e2021 = phi_3080_;
                    phi_3081_ = _e2021;
                } else {
                    phi_3081_ = false;
                }
                let _e2023 = phi_3081_;
                continue;
                continuing {
                    phi_2964_ = _e1979;
                    break if !(_e2023);
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
