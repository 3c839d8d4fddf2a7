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

struct type_20 {
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

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
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
var<storage> params: type_22;
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_28;
@group(0) @binding(1) 
var<storage> a: type_18;
@group(0) @binding(2) 
var<storage> b: type_18;
@group(0) @binding(3) 
var<storage, read_write> control: type_28;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_28;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_166_: u32;
    var phi_204_: type_9;
    var phi_205_: type_9;
    var phi_228_: type_9;
    var phi_252_: u32;
    var phi_283_: bool;
    var phi_287_: u32;
    var phi_288_: u32;
    var phi_289_: u32;
    var phi_349_: u32;
    var phi_354_: u32;
    var phi_359_: u32;
    var phi_372_: u32;
    var phi_378_: u32;
    var phi_387_: u32;
    var phi_317_: u32;
    var phi_323_: u32;
    var phi_388_: u32;
    var phi_389_: u32;
    var phi_390_: u32;
    var phi_410_: u32;
    var phi_411_: u32;
    var phi_494_: array<u32, 2>;
    var phi_495_: array<u32, 2>;
    var phi_512_: array<u32, 2>;
    var phi_541_: u32;
    var phi_615_: array<u32, 2>;
    var phi_629_: array<u32, 2>;
    var phi_666_: array<u32, 2>;
    var phi_668_: type_24;
    var phi_669_: type_24;
    var phi_670_: bool;
    var phi_671_: type_24;
    var phi_672_: bool;
    var phi_688_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_843_: array<u32, 2>;
    var phi_872_: array<u32, 2>;
    var phi_901_: array<u32, 2>;
    var phi_930_: array<u32, 2>;
    var phi_932_: type_24;
    var phi_933_: bool;
    var phi_934_: type_24;
    var phi_935_: bool;
    var phi_1108_: array<u32, 2>;
    var phi_1140_: array<u32, 2>;
    var phi_1008_: array<u32, 2>;
    var phi_1040_: array<u32, 2>;
    var phi_1142_: type_24;
    var phi_1143_: type_24;
    var phi_1144_: type_24;
    var phi_1145_: bool;
    var phi_1146_: type_24;
    var phi_1147_: type_24;
    var phi_1148_: bool;
    var phi_1152_: type_24;
    var phi_1163_: array<array<u32, 2>, 4>;
    var phi_1181_: bool;
    var phi_1182_: bool;
    var phi_1186_: u32;
    var phi_1187_: u32;
    var phi_1199_: type_25;
    var phi_1200_: type_25;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1223_: u32;
    var phi_1224_: u32;
    var phi_1236_: type_25;
    var phi_1237_: type_25;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1260_: u32;
    var phi_1261_: u32;
    var phi_1273_: type_25;
    var phi_1274_: type_25;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1297_: u32;
    var phi_1298_: u32;
    var phi_1310_: type_25;
    var phi_1311_: type_25;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1332_: u32;
    var phi_1333_: u32;
    var phi_1339_: type_25;
    var phi_1340_: type_25;
    var phi_1341_: type_25;
    var phi_1342_: type_25;
    var phi_1343_: type_25;
    var phi_1363_: array<u32, 2>;
    var phi_1364_: array<u32, 2>;
    var phi_1376_: array<u32, 2>;
    var phi_1377_: array<u32, 2>;
    var phi_1394_: array<u32, 2>;
    var phi_1395_: array<u32, 2>;
    var phi_1407_: array<u32, 2>;
    var phi_1408_: array<u32, 2>;
    var phi_1425_: array<u32, 2>;
    var phi_1426_: array<u32, 2>;
    var phi_1438_: array<u32, 2>;
    var phi_1439_: array<u32, 2>;
    var phi_1456_: array<u32, 2>;
    var phi_1457_: array<u32, 2>;
    var phi_1469_: array<u32, 2>;
    var phi_1470_: array<u32, 2>;
    var phi_1514_: u32;
    var phi_1699_: type_9;
    var phi_1704_: type_9;
    var phi_1862_: type_9;
    var phi_1867_: type_9;
    var phi_2025_: type_9;
    var phi_2030_: type_9;
    var phi_2188_: type_9;
    var phi_2193_: type_9;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2270_: u32;
    var phi_2275_: u32;
    var phi_2348_: type_9;
    var phi_2349_: type_9;
    var phi_2372_: type_9;
    var phi_2432_: u32;
    var phi_2435_: type_9;
    var phi_2436_: type_9;
    var phi_2459_: type_9;
    var phi_2540_: type_9;
    var phi_2541_: type_9;
    var phi_2564_: type_9;
    var phi_2656_: bool;
    var phi_2657_: bool;
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
    let _e72 = params.member.member_1;
    let _e75 = (_e72.member_1 % 2u);
    let _e77 = atomicLoad((&control.member[_e72.member_1]));
    if (_e70.member_3 < _e77) {
        phi_166_ = _e70.member_3;
    } else {
        phi_166_ = _e77;
    }
    let _e80 = phi_166_;
    let _e81 = (_e75 * _e70.member_3);
    let _e83 = ((1u - _e75) * _e70.member_3);
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_204_ = type_9(0u, _e70.member_11);
    loop {
        let _e92 = phi_204_;
        if (_e92.member < _e92.member_1) {
            phi_205_ = type_9((_e92.member + 1u), _e92.member_1);
            phi_228_ = type_9(1u, _e92.member);
        } else {
            phi_205_ = _e92;
            phi_228_ = type_9(0u, type_9().member_1);
        }
        let _e104 = phi_205_;
        let _e106 = phi_228_;
        if (bitcast<i32>(_e106.member) != 0i) {
            if (_e56 == 0u) {
                let _e117 = atomicLoad((&shared_[0u]));
                if (128u < _e117) {
                    phi_252_ = 128u;
                } else {
                    phi_252_ = _e117;
                }
                let _e120 = phi_252_;
                if (_e70.member_9 > 0u) {
                    if (_e106.member_1 >= 16u) {
                        let _e125 = atomicLoad((&control.member[(1024u + _e72.member_1)]));
                        if (_e70.member_9 > 0u) {
                            phi_283_ = ((_e125 * 100u) >= (_e70.member_9 << bitcast<u32>((_e70.member_7 & 31u))));
                        } else {
                            phi_283_ = false;
                        }
                        let _e133 = phi_283_;
                        if _e133 {
                            phi_287_ = 2u;
                        } else {
                            phi_287_ = 0u;
                        }
                        let _e135 = phi_287_;
                        phi_288_ = _e135;
                    } else {
                        phi_288_ = 0u;
                    }
                    let _e137 = phi_288_;
                    phi_289_ = _e137;
                } else {
                    phi_289_ = 0u;
                }
                let _e139 = phi_289_;
                let _e140 = (128u - _e120);
                if (_e139 == 0u) {
                    if (_e140 > 0u) {
                        let _e144 = atomicLoad((&shared_[5u]));
                        if (_e70.member_6 == 0u) {
                            if (_e68 < _e80) {
                                phi_317_ = ((((_e80 - 1u) - _e68) >> bitcast<u32>((_e70.member_7 & 31u))) + 1u);
                            } else {
                                phi_317_ = 0u;
                            }
                            let _e185 = phi_317_;
                            let _e186 = (_e185 - _e144);
                            if (_e140 < _e186) {
                                phi_323_ = _e140;
                            } else {
                                phi_323_ = _e186;
                            }
                            let _e189 = phi_323_;
                            atomicStore((&shared_[3u]), (_e68 + (_e144 << bitcast<u32>((_e70.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e70.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e144 + _e189));
                            phi_388_ = _e189;
                        } else {
                            if (_e144 == 0u) {
                                let _e150 = (_e80 >> bitcast<u32>(((_e70.member_7 + 2u) & 31u)));
                                if (_e70.member_8 < _e150) {
                                    phi_349_ = _e150;
                                } else {
                                    phi_349_ = _e70.member_8;
                                }
                                let _e153 = phi_349_;
                                if (128u < _e153) {
                                    phi_354_ = 128u;
                                } else {
                                    phi_354_ = _e153;
                                }
                                let _e156 = phi_354_;
                                if (_e140 < _e156) {
                                    phi_359_ = _e140;
                                } else {
                                    phi_359_ = _e156;
                                }
                                let _e159 = phi_359_;
                                let _e162 = atomicAdd((&control.member[(512u + _e72.member_1)]), _e159);
                                if (_e80 < _e162) {
                                    phi_372_ = _e80;
                                } else {
                                    phi_372_ = _e162;
                                }
                                let _e165 = phi_372_;
                                let _e166 = (_e80 - _e165);
                                if (_e159 < _e166) {
                                    phi_378_ = _e159;
                                } else {
                                    phi_378_ = _e166;
                                }
                                let _e169 = phi_378_;
                                atomicStore((&shared_[3u]), _e162);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e169 < _e159)));
                                phi_387_ = _e169;
                            } else {
                                phi_387_ = 0u;
                            }
                            let _e176 = phi_387_;
                            phi_388_ = _e176;
                        }
                        let _e202 = phi_388_;
                        phi_389_ = _e202;
                    } else {
                        phi_389_ = 0u;
                    }
                    let _e204 = phi_389_;
                    phi_390_ = _e204;
                } else {
                    phi_390_ = 0u;
                }
                let _e206 = phi_390_;
                if (_e139 == 0u) {
                    if ((_e120 + _e206) == 0u) {
                        if (_e70.member_9 > 0u) {
                            let _e213 = atomicAdd((&control.member[(1024u + _e72.member_1)]), 1u);
                        }
                        phi_410_ = 1u;
                    } else {
                        phi_410_ = _e139;
                    }
                    let _e215 = phi_410_;
                    phi_411_ = _e215;
                } else {
                    phi_411_ = _e139;
                }
                let _e217 = phi_411_;
                atomicStore((&shared_[1u]), _e120);
                atomicStore((&shared_[2u]), _e206);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e217;
            }
            let _e225 = workgroupUniformLoad((&state[0u]));
            if (_e225 != 0u) {
                phi_2246_ = false;
            } else {
                let _e228 = atomicLoad((&shared_[1u]));
                let _e230 = atomicLoad((&shared_[2u]));
                if (_e56 < _e228) {
                    let _e253 = atomicLoad((&shared_[0u]));
                    let _e256 = (2u * ((_e253 - 1u) - _e56));
                    let _e258 = stack[_e256];
                    let _e261 = stack[(_e256 + 1u)];
                    phi_495_ = array<u32, 2>(_e258, _e261);
                } else {
                    if (_e56 < (_e228 + _e230)) {
                        let _e235 = atomicLoad((&shared_[3u]));
                        let _e238 = atomicLoad((&shared_[4u]));
                        let _e242 = (2u * (_e81 + (_e235 + ((_e56 - _e228) * _e238))));
                        let _e245 = atomicLoad((&nodes.member[(4u + _e242)]));
                        let _e248 = atomicLoad((&nodes.member[(_e242 + 5u)]));
                        phi_494_ = array<u32, 2>(_e245, _e248);
                    } else {
                        phi_494_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e251 = phi_494_;
                    phi_495_ = _e251;
                }
                let _e264 = phi_495_;
                let _e267 = params.member.member_2.member;
                let _e271 = params.member.member_2.member;
                if (_e271 == 0u) {
                    phi_512_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_512_ = array<u32, 2>(1u, 1u);
                }
                let _e274 = phi_512_;
                let _e280 = params.member.member.member[_e274[0]];
                let _e281 = (_e280 - 1u);
                let _e285 = params.member.member.member[_e274[1]];
                let _e286 = (_e285 - 1u);
                let _e289 = params.member.member_2.member_1;
                if (_e289 == 0u) {
                    phi_541_ = 1u;
                } else {
                    phi_541_ = 0u;
                }
                let _e292 = phi_541_;
                if (_e264[0] != 4294967295u) {
                    let _e298 = a.member[_e264[0]];
                    let _e300 = b.member[_e264[1]];
                    if (_e267 == 1u) {
                        if (_e264[0] == _e264[1]) {
                            if (_e298.member_3 == 4294967295u) {
                                phi_668_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e306 = a.member[_e298.member_1];
                                let _e309 = a.member[_e298.member_3];
                                if !((_e306.member_3 == 4294967295u)) {
                                    phi_615_ = array<u32, 2>(_e298.member_1, _e298.member_1);
                                } else {
                                    phi_615_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e316 = phi_615_;
                                let _e323 = type_24(array<array<u32, 2>, 4>(_e316, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e335 = type_24(array<array<u32, 2>, 4>(_e323.member[0], array<u32, 2>(_e298.member_1, _e323.member[1][1]), _e323.member[2], _e323.member[3]), _e323.member_1);
                                let _e336 = array<u32, 2>(_e298.member_1, _e298.member_3);
                                let _e343 = type_24(array<array<u32, 2>, 4>(_e335.member[0], _e336, _e335.member[2], _e335.member[3]), _e335.member_1);
                                if !((_e309.member_3 == 4294967295u)) {
                                    phi_629_ = array<u32, 2>(_e298.member_3, _e298.member_3);
                                } else {
                                    phi_629_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e350 = phi_629_;
                                let _e357 = type_24(array<array<u32, 2>, 4>(_e343.member[0], _e343.member[1], _e350, _e343.member[3]), _e343.member_1);
                                let _e360 = type_24(_e357.member, _e357.member);
                                if ((((((_e306.member[0] <= _e309.member_2[0]) && (_e309.member[0] <= _e306.member_2[0])) && (_e306.member[1] <= _e309.member_2[1])) && (_e309.member[1] <= _e306.member_2[1])) && (_e306.member[2] <= _e309.member_2[2])) && (_e309.member[2] <= _e306.member_2[2])) {
                                    phi_666_ = _e336;
                                } else {
                                    phi_666_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e389 = phi_666_;
                                phi_668_ = type_24(_e360.member, array<array<u32, 2>, 4>(_e360.member_1[0], _e389, _e360.member_1[2], _e360.member_1[3]));
                            }
                            let _e398 = phi_668_;
                            phi_669_ = _e398;
                            phi_670_ = false;
                        } else {
                            phi_669_ = type_24();
                            phi_670_ = true;
                        }
                        let _e400 = phi_669_;
                        let _e402 = phi_670_;
                        phi_671_ = _e400;
                        phi_672_ = _e402;
                    } else {
                        phi_671_ = type_24();
                        phi_672_ = true;
                    }
                    let _e404 = phi_671_;
                    let _e406 = phi_672_;
                    if _e406 {
                        let _e409 = !((_e298.member_3 == 4294967295u));
                        let _e412 = !((_e300.member_3 == 4294967295u));
                        if _e409 {
                            phi_688_ = true;
                        } else {
                            phi_688_ = _e412;
                        }
                        let _e414 = phi_688_;
                        if _e414 {
                            if _e409 {
                                if _e412 {
                                    if (_e292 == 0u) {
                                        let _e442 = ((((_e300.member_2[0] - _e300.member[0]) * (_e300.member_2[1] - _e300.member[1])) * (_e300.member_2[2] - _e300.member[2])) > (((_e298.member_2[0] - _e298.member[0]) * (_e298.member_2[1] - _e298.member[1])) * (_e298.member_2[2] - _e298.member[2])));
                                        phi_732_ = _e442;
                                        phi_733_ = !(_e442);
                                    } else {
                                        phi_732_ = _e412;
                                        phi_733_ = _e409;
                                    }
                                    let _e445 = phi_732_;
                                    let _e447 = phi_733_;
                                    phi_734_ = _e445;
                                    phi_735_ = _e447;
                                } else {
                                    phi_734_ = _e412;
                                    phi_735_ = _e409;
                                }
                                let _e449 = phi_734_;
                                let _e451 = phi_735_;
                                phi_736_ = _e449;
                                phi_737_ = _e451;
                            } else {
                                phi_736_ = _e412;
                                phi_737_ = _e409;
                            }
                            let _e453 = phi_736_;
                            let _e455 = phi_737_;
                            if _e455 {
                                if _e453 {
                                    let _e458 = a.member[_e298.member_1];
                                    let _e463 = a.member[_e298.member_3];
                                    let _e468 = b.member[_e300.member_1];
                                    let _e473 = b.member[_e300.member_3];
                                    let _e478 = array<u32, 2>(_e298.member_1, _e300.member_1);
                                    let _e481 = array<u32, 2>(_e298.member_1, _e300.member_3);
                                    let _e484 = array<u32, 2>(_e298.member_3, _e300.member_1);
                                    let _e487 = array<u32, 2>(_e298.member_3, _e300.member_3);
                                    if ((((((_e458.member[0] <= _e468.member_2[0]) && (_e468.member[0] <= _e458.member_2[0])) && (_e458.member[1] <= _e468.member_2[1])) && (_e468.member[1] <= _e458.member_2[1])) && (_e458.member[2] <= _e468.member_2[2])) && (_e468.member[2] <= _e458.member_2[2])) {
                                        phi_843_ = _e478;
                                    } else {
                                        phi_843_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e513 = phi_843_;
                                    if ((((((_e458.member[0] <= _e473.member_2[0]) && (_e473.member[0] <= _e458.member_2[0])) && (_e458.member[1] <= _e473.member_2[1])) && (_e473.member[1] <= _e458.member_2[1])) && (_e458.member[2] <= _e473.member_2[2])) && (_e473.member[2] <= _e458.member_2[2])) {
                                        phi_872_ = _e481;
                                    } else {
                                        phi_872_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e538 = phi_872_;
                                    if ((((((_e463.member[0] <= _e468.member_2[0]) && (_e468.member[0] <= _e463.member_2[0])) && (_e463.member[1] <= _e468.member_2[1])) && (_e468.member[1] <= _e463.member_2[1])) && (_e463.member[2] <= _e468.member_2[2])) && (_e468.member[2] <= _e463.member_2[2])) {
                                        phi_901_ = _e484;
                                    } else {
                                        phi_901_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e563 = phi_901_;
                                    if ((((((_e463.member[0] <= _e473.member_2[0]) && (_e473.member[0] <= _e463.member_2[0])) && (_e463.member[1] <= _e473.member_2[1])) && (_e473.member[1] <= _e463.member_2[1])) && (_e463.member[2] <= _e473.member_2[2])) && (_e473.member[2] <= _e463.member_2[2])) {
                                        phi_930_ = _e487;
                                    } else {
                                        phi_930_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e588 = phi_930_;
                                    phi_932_ = type_24(array<array<u32, 2>, 4>(_e478, _e481, _e484, _e487), array<array<u32, 2>, 4>(_e513, _e538, _e563, _e588));
                                    phi_933_ = false;
                                } else {
                                    phi_932_ = type_24();
                                    phi_933_ = true;
                                }
                                let _e592 = phi_932_;
                                let _e594 = phi_933_;
                                phi_934_ = _e592;
                                phi_935_ = _e594;
                            } else {
                                phi_934_ = type_24();
                                phi_935_ = true;
                            }
                            let _e596 = phi_934_;
                            let _e598 = phi_935_;
                            if _e598 {
                                if _e455 {
                                    let _e686 = a.member[_e298.member_1];
                                    let _e691 = a.member[_e298.member_3];
                                    let _e695 = array<u32, 2>(_e298.member_1, _e264[1]);
                                    let _e697 = array<u32, 2>(_e298.member_3, _e264[1]);
                                    let _e700 = type_24(array<array<u32, 2>, 4>(_e695, _e697, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e686.member[0] <= _e300.member_2[0]) && (_e300.member[0] <= _e686.member_2[0])) && (_e686.member[1] <= _e300.member_2[1])) && (_e300.member[1] <= _e686.member_2[1])) && (_e686.member[2] <= _e300.member_2[2])) && (_e300.member[2] <= _e686.member_2[2])) {
                                        phi_1008_ = _e695;
                                    } else {
                                        phi_1008_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e727 = phi_1008_;
                                    let _e734 = type_24(_e700.member, array<array<u32, 2>, 4>(_e727, _e700.member_1[1], _e700.member_1[2], _e700.member_1[3]));
                                    if ((((((_e691.member[0] <= _e300.member_2[0]) && (_e300.member[0] <= _e691.member_2[0])) && (_e691.member[1] <= _e300.member_2[1])) && (_e300.member[1] <= _e691.member_2[1])) && (_e691.member[2] <= _e300.member_2[2])) && (_e300.member[2] <= _e691.member_2[2])) {
                                        phi_1040_ = _e697;
                                    } else {
                                        phi_1040_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e761 = phi_1040_;
                                    phi_1142_ = type_24(_e734.member, array<array<u32, 2>, 4>(_e734.member_1[0], _e761, _e734.member_1[2], _e734.member_1[3]));
                                } else {
                                    let _e601 = b.member[_e300.member_1];
                                    let _e606 = b.member[_e300.member_3];
                                    let _e610 = array<u32, 2>(_e264[0], _e300.member_1);
                                    let _e612 = array<u32, 2>(_e264[0], _e300.member_3);
                                    let _e615 = type_24(array<array<u32, 2>, 4>(_e610, _e612, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e298.member[0] <= _e601.member_2[0]) && (_e601.member[0] <= _e298.member_2[0])) && (_e298.member[1] <= _e601.member_2[1])) && (_e601.member[1] <= _e298.member_2[1])) && (_e298.member[2] <= _e601.member_2[2])) && (_e601.member[2] <= _e298.member_2[2])) {
                                        phi_1108_ = _e610;
                                    } else {
                                        phi_1108_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e642 = phi_1108_;
                                    let _e649 = type_24(_e615.member, array<array<u32, 2>, 4>(_e642, _e615.member_1[1], _e615.member_1[2], _e615.member_1[3]));
                                    if ((((((_e298.member[0] <= _e606.member_2[0]) && (_e606.member[0] <= _e298.member_2[0])) && (_e298.member[1] <= _e606.member_2[1])) && (_e606.member[1] <= _e298.member_2[1])) && (_e298.member[2] <= _e606.member_2[2])) && (_e606.member[2] <= _e298.member_2[2])) {
                                        phi_1140_ = _e612;
                                    } else {
                                        phi_1140_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e676 = phi_1140_;
                                    phi_1142_ = type_24(_e649.member, array<array<u32, 2>, 4>(_e649.member_1[0], _e676, _e649.member_1[2], _e649.member_1[3]));
                                }
                                let _e770 = phi_1142_;
                                phi_1143_ = _e770;
                            } else {
                                phi_1143_ = _e596;
                            }
                            let _e772 = phi_1143_;
                            phi_1144_ = _e772;
                            phi_1145_ = false;
                        } else {
                            phi_1144_ = type_24();
                            phi_1145_ = true;
                        }
                        let _e774 = phi_1144_;
                        let _e776 = phi_1145_;
                        phi_1146_ = _e774;
                        phi_1147_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1148_ = _e776;
                    } else {
                        phi_1146_ = type_24();
                        phi_1147_ = _e404;
                        phi_1148_ = true;
                    }
                    let _e778 = phi_1146_;
                    let _e780 = phi_1147_;
                    let _e782 = phi_1148_;
                    if _e782 {
                        phi_1152_ = _e780;
                    } else {
                        phi_1152_ = _e778;
                    }
                    let _e784 = phi_1152_;
                    let _e788 = params.member.member_2.member_4;
                    if (_e788 > 0u) {
                        phi_1163_ = _e784.member;
                    } else {
                        phi_1163_ = _e784.member_1;
                    }
                    let _e792 = phi_1163_;
                    if (_e784.member_1[0][0] == 4294967295u) {
                        phi_1187_ = 0u;
                    } else {
                        if (_e784.member_1[0][0] >= _e281) {
                            if (_e784.member_1[0][1] >= _e286) {
                                phi_1181_ = false;
                            } else {
                                phi_1181_ = true;
                            }
                            let _e802 = phi_1181_;
                            phi_1182_ = _e802;
                        } else {
                            phi_1182_ = true;
                        }
                        let _e804 = phi_1182_;
                        if _e804 {
                            phi_1186_ = 1u;
                        } else {
                            phi_1186_ = 2u;
                        }
                        let _e806 = phi_1186_;
                        phi_1187_ = _e806;
                    }
                    let _e808 = phi_1187_;
                    let _e809 = type_25(_e784.member_1[0], _e808);
                    if (_e808 == 0u) {
                        if (_e792[0][0] != 4294967295u) {
                            phi_1199_ = type_25(_e792[0], 3u);
                        } else {
                            phi_1199_ = _e809;
                        }
                        let _e815 = phi_1199_;
                        phi_1200_ = _e815;
                    } else {
                        phi_1200_ = _e809;
                    }
                    let _e817 = phi_1200_;
                    if (_e784.member_1[1][0] == 4294967295u) {
                        phi_1224_ = 0u;
                    } else {
                        if (_e784.member_1[1][0] >= _e281) {
                            if (_e784.member_1[1][1] >= _e286) {
                                phi_1218_ = false;
                            } else {
                                phi_1218_ = true;
                            }
                            let _e827 = phi_1218_;
                            phi_1219_ = _e827;
                        } else {
                            phi_1219_ = true;
                        }
                        let _e829 = phi_1219_;
                        if _e829 {
                            phi_1223_ = 1u;
                        } else {
                            phi_1223_ = 2u;
                        }
                        let _e831 = phi_1223_;
                        phi_1224_ = _e831;
                    }
                    let _e833 = phi_1224_;
                    let _e834 = type_25(_e784.member_1[1], _e833);
                    if (_e833 == 0u) {
                        if (_e792[1][0] != 4294967295u) {
                            phi_1236_ = type_25(_e792[1], 3u);
                        } else {
                            phi_1236_ = _e834;
                        }
                        let _e840 = phi_1236_;
                        phi_1237_ = _e840;
                    } else {
                        phi_1237_ = _e834;
                    }
                    let _e842 = phi_1237_;
                    if (_e784.member_1[2][0] == 4294967295u) {
                        phi_1261_ = 0u;
                    } else {
                        if (_e784.member_1[2][0] >= _e281) {
                            if (_e784.member_1[2][1] >= _e286) {
                                phi_1255_ = false;
                            } else {
                                phi_1255_ = true;
                            }
                            let _e852 = phi_1255_;
                            phi_1256_ = _e852;
                        } else {
                            phi_1256_ = true;
                        }
                        let _e854 = phi_1256_;
                        if _e854 {
                            phi_1260_ = 1u;
                        } else {
                            phi_1260_ = 2u;
                        }
                        let _e856 = phi_1260_;
                        phi_1261_ = _e856;
                    }
                    let _e858 = phi_1261_;
                    let _e859 = type_25(_e784.member_1[2], _e858);
                    if (_e858 == 0u) {
                        if (_e792[2][0] != 4294967295u) {
                            phi_1273_ = type_25(_e792[2], 3u);
                        } else {
                            phi_1273_ = _e859;
                        }
                        let _e865 = phi_1273_;
                        phi_1274_ = _e865;
                    } else {
                        phi_1274_ = _e859;
                    }
                    let _e867 = phi_1274_;
                    if (_e784.member_1[3][0] == 4294967295u) {
                        phi_1298_ = 0u;
                    } else {
                        if (_e784.member_1[3][0] >= _e281) {
                            if (_e784.member_1[3][1] >= _e286) {
                                phi_1292_ = false;
                            } else {
                                phi_1292_ = true;
                            }
                            let _e877 = phi_1292_;
                            phi_1293_ = _e877;
                        } else {
                            phi_1293_ = true;
                        }
                        let _e879 = phi_1293_;
                        if _e879 {
                            phi_1297_ = 1u;
                        } else {
                            phi_1297_ = 2u;
                        }
                        let _e881 = phi_1297_;
                        phi_1298_ = _e881;
                    }
                    let _e883 = phi_1298_;
                    let _e884 = type_25(_e784.member_1[3], _e883);
                    if (_e883 == 0u) {
                        if (_e792[3][0] != 4294967295u) {
                            phi_1310_ = type_25(_e792[3], 3u);
                        } else {
                            phi_1310_ = _e884;
                        }
                        let _e890 = phi_1310_;
                        phi_1311_ = _e890;
                    } else {
                        phi_1311_ = _e884;
                    }
                    let _e892 = phi_1311_;
                    if (_e264[0] == 4294967295u) {
                        phi_1333_ = 0u;
                    } else {
                        if (_e264[0] >= _e281) {
                            if (_e264[1] >= _e286) {
                                phi_1327_ = false;
                            } else {
                                phi_1327_ = true;
                            }
                            let _e900 = phi_1327_;
                            phi_1328_ = _e900;
                        } else {
                            phi_1328_ = true;
                        }
                        let _e902 = phi_1328_;
                        if _e902 {
                            phi_1332_ = 1u;
                        } else {
                            phi_1332_ = 2u;
                        }
                        let _e904 = phi_1332_;
                        phi_1333_ = _e904;
                    }
                    let _e906 = phi_1333_;
                    if (_e906 == 2u) {
                        phi_1339_ = type_25(_e264, 2u);
                    } else {
                        phi_1339_ = _e817;
                    }
                    let _e910 = phi_1339_;
                    phi_1340_ = _e910;
                    phi_1341_ = _e892;
                    phi_1342_ = _e867;
                    phi_1343_ = _e842;
                } else {
                    phi_1340_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1341_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1342_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1343_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e912 = phi_1340_;
                let _e914 = phi_1341_;
                let _e916 = phi_1342_;
                let _e918 = phi_1343_;
                if (_e912.member_1 == 1u) {
                    let _e929 = atomicAdd((&shared_[6u]), 1u);
                    phi_1364_ = array<u32, 2>(_e929, 0u);
                } else {
                    if (_e912.member_1 == 2u) {
                        let _e924 = atomicAdd((&shared_[7u]), 1u);
                        phi_1363_ = array<u32, 2>(_e924, 0u);
                    } else {
                        phi_1363_ = array<u32, 2>(0u, 0u);
                    }
                    let _e927 = phi_1363_;
                    phi_1364_ = _e927;
                }
                let _e932 = phi_1364_;
                if (_e912.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e936 = atomicAdd((&shared_[8u]), 1u);
                        phi_1376_ = array<u32, 2>(_e932[0], _e936);
                    } else {
                        phi_1376_ = _e932;
                    }
                    let _e940 = phi_1376_;
                    phi_1377_ = _e940;
                } else {
                    phi_1377_ = _e932;
                }
                let _e942 = phi_1377_;
                if (_e918.member_1 == 1u) {
                    let _e952 = atomicAdd((&shared_[6u]), 1u);
                    phi_1395_ = array<u32, 2>(_e952, 0u);
                } else {
                    if (_e918.member_1 == 2u) {
                        let _e947 = atomicAdd((&shared_[7u]), 1u);
                        phi_1394_ = array<u32, 2>(_e947, 0u);
                    } else {
                        phi_1394_ = array<u32, 2>(0u, 0u);
                    }
                    let _e950 = phi_1394_;
                    phi_1395_ = _e950;
                }
                let _e955 = phi_1395_;
                if (_e918.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e959 = atomicAdd((&shared_[8u]), 1u);
                        phi_1407_ = array<u32, 2>(_e955[0], _e959);
                    } else {
                        phi_1407_ = _e955;
                    }
                    let _e963 = phi_1407_;
                    phi_1408_ = _e963;
                } else {
                    phi_1408_ = _e955;
                }
                let _e965 = phi_1408_;
                if (_e916.member_1 == 1u) {
                    let _e975 = atomicAdd((&shared_[6u]), 1u);
                    phi_1426_ = array<u32, 2>(_e975, 0u);
                } else {
                    if (_e916.member_1 == 2u) {
                        let _e970 = atomicAdd((&shared_[7u]), 1u);
                        phi_1425_ = array<u32, 2>(_e970, 0u);
                    } else {
                        phi_1425_ = array<u32, 2>(0u, 0u);
                    }
                    let _e973 = phi_1425_;
                    phi_1426_ = _e973;
                }
                let _e978 = phi_1426_;
                if (_e916.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e982 = atomicAdd((&shared_[8u]), 1u);
                        phi_1438_ = array<u32, 2>(_e978[0], _e982);
                    } else {
                        phi_1438_ = _e978;
                    }
                    let _e986 = phi_1438_;
                    phi_1439_ = _e986;
                } else {
                    phi_1439_ = _e978;
                }
                let _e988 = phi_1439_;
                if (_e914.member_1 == 1u) {
                    let _e998 = atomicAdd((&shared_[6u]), 1u);
                    phi_1457_ = array<u32, 2>(_e998, 0u);
                } else {
                    if (_e914.member_1 == 2u) {
                        let _e993 = atomicAdd((&shared_[7u]), 1u);
                        phi_1456_ = array<u32, 2>(_e993, 0u);
                    } else {
                        phi_1456_ = array<u32, 2>(0u, 0u);
                    }
                    let _e996 = phi_1456_;
                    phi_1457_ = _e996;
                }
                let _e1001 = phi_1457_;
                if (_e914.member_1 >= 2u) {
                    if (_e70.member_4 > 0u) {
                        let _e1005 = atomicAdd((&shared_[8u]), 1u);
                        phi_1469_ = array<u32, 2>(_e1001[0], _e1005);
                    } else {
                        phi_1469_ = _e1001;
                    }
                    let _e1009 = phi_1469_;
                    phi_1470_ = _e1009;
                } else {
                    phi_1470_ = _e1001;
                }
                let _e1011 = phi_1470_;
                workgroupBarrier();
                if (_e56 == 0u) {
                    let _e1014 = atomicLoad((&shared_[6u]));
                    let _e1016 = atomicLoad((&shared_[7u]));
                    let _e1018 = atomicLoad((&shared_[8u]));
                    let _e1020 = atomicLoad((&shared_[1u]));
                    let _e1022 = atomicLoad((&shared_[2u]));
                    let _e1024 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e1024 + 1u));
                    let _e1028 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e1028 + _e1020) + _e1022));
                    let _e1033 = atomicLoad((&shared_[0u]));
                    let _e1034 = (_e1033 - _e1020);
                    let _e1036 = (_e70.member_10 - _e1034);
                    if (_e1036 < _e1014) {
                        phi_1514_ = _e1036;
                    } else {
                        phi_1514_ = _e1014;
                    }
                    let _e1039 = phi_1514_;
                    atomicStore((&shared_[9u]), _e1034);
                    atomicStore((&shared_[10u]), _e1039);
                    atomicStore((&shared_[0u]), (_e1034 + _e1039));
                    if (_e1014 > _e1039) {
                        let _e1045 = (_e1014 - _e1039);
                        if (_e70.member_12 == 0u) {
                        } else {
                            let _e1049 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1052 = atomicAdd((&control.member[(_e72.member_1 + 1u)]), _e1045);
                        let _e1055 = atomicMax((&nodes.member[0u]), (_e1052 + _e1045));
                        if ((_e1052 + _e1045) < _e1052) {
                            let _e1059 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e1052);
                    }
                    if (_e1016 > 0u) {
                        let _e1063 = atomicAdd((&pairs.member[0u]), _e1016);
                        if ((_e1063 + _e1016) < _e1063) {
                            let _e1067 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e1063);
                    }
                    if (_e1018 > 0u) {
                        let _e1071 = atomicAdd((&control.member[1537u]), _e1018);
                        if ((_e1071 + _e1018) < _e1071) {
                            let _e1075 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e1071);
                    }
                }
                workgroupBarrier();
                if (_e912.member_1 == 1u) {
                    let _e1138 = atomicLoad((&shared_[10u]));
                    if (_e942[0] < _e1138) {
                        let _e1158 = atomicLoad((&shared_[9u]));
                        let _e1161 = (2u * (_e1158 + _e942[0]));
                        stack[_e1161] = _e912.member[0];
                        stack[(_e1161 + 1u)] = _e912.member[1];
                    } else {
                        let _e1142 = atomicLoad((&shared_[11u]));
                        let _e1145 = ((_e1142 + _e942[0]) - _e1138);
                        if (_e1145 < _e70.member_3) {
                            let _e1148 = (_e83 + _e1145);
                            if (_e1148 < 4294967295u) {
                                let _e1152 = (2u * _e1148);
                                atomicStore((&nodes.member[(4u + _e1152)]), _e912.member[0]);
                                atomicStore((&nodes.member[(_e1152 + 5u)]), _e912.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e912.member_1 == 0u) {
                    } else {
                        if (_e912.member_1 == 2u) {
                            let _e1086 = a.member[_e912.member[0]];
                            let _e1090 = b.member[_e912.member[1]];
                            let _e1094 = params.member.member_2.member;
                            if (_e1094 == 1u) {
                                if (_e1086.member_1 < _e1090.member_1) {
                                    phi_1699_ = type_9(_e1086.member_1, _e1090.member_1);
                                } else {
                                    phi_1699_ = type_9(_e1090.member_1, _e1086.member_1);
                                }
                                let _e1101 = phi_1699_;
                                phi_1704_ = _e1101;
                            } else {
                                phi_1704_ = type_9(_e1086.member_1, _e1090.member_1);
                            }
                            let _e1103 = phi_1704_;
                            let _e1107 = params.member.member_1;
                            let _e1110 = atomicLoad((&shared_[12u]));
                            let _e1112 = (_e1110 + _e942[0]);
                            if (_e1112 < _e1107.member_3) {
                                let _e1114 = (2u * _e1112);
                                atomicStore((&pairs.member[(4u + _e1114)]), _e1103.member);
                                atomicStore((&pairs.member[(_e1114 + 5u)]), _e1103.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1122 = atomicLoad((&shared_[13u]));
                            let _e1124 = (_e1122 + _e942[1]);
                            if (_e1124 < _e70.member_4) {
                                let _e1131 = (2u * ((_e70.member_5 * _e70.member_4) + _e1124));
                                front.member[_e1131] = _e912.member[0];
                                front.member[(_e1131 + 1u)] = _e912.member[1];
                            }
                        }
                    }
                }
                if (_e918.member_1 == 1u) {
                    let _e1228 = atomicLoad((&shared_[10u]));
                    if (_e965[0] < _e1228) {
                        let _e1248 = atomicLoad((&shared_[9u]));
                        let _e1251 = (2u * (_e1248 + _e965[0]));
                        stack[_e1251] = _e918.member[0];
                        stack[(_e1251 + 1u)] = _e918.member[1];
                    } else {
                        let _e1232 = atomicLoad((&shared_[11u]));
                        let _e1235 = ((_e1232 + _e965[0]) - _e1228);
                        if (_e1235 < _e70.member_3) {
                            let _e1238 = (_e83 + _e1235);
                            if (_e1238 < 4294967295u) {
                                let _e1242 = (2u * _e1238);
                                atomicStore((&nodes.member[(4u + _e1242)]), _e918.member[0]);
                                atomicStore((&nodes.member[(_e1242 + 5u)]), _e918.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e918.member_1 == 0u) {
                    } else {
                        if (_e918.member_1 == 2u) {
                            let _e1176 = a.member[_e918.member[0]];
                            let _e1180 = b.member[_e918.member[1]];
                            let _e1184 = params.member.member_2.member;
                            if (_e1184 == 1u) {
                                if (_e1176.member_1 < _e1180.member_1) {
                                    phi_1862_ = type_9(_e1176.member_1, _e1180.member_1);
                                } else {
                                    phi_1862_ = type_9(_e1180.member_1, _e1176.member_1);
                                }
                                let _e1191 = phi_1862_;
                                phi_1867_ = _e1191;
                            } else {
                                phi_1867_ = type_9(_e1176.member_1, _e1180.member_1);
                            }
                            let _e1193 = phi_1867_;
                            let _e1197 = params.member.member_1;
                            let _e1200 = atomicLoad((&shared_[12u]));
                            let _e1202 = (_e1200 + _e965[0]);
                            if (_e1202 < _e1197.member_3) {
                                let _e1204 = (2u * _e1202);
                                atomicStore((&pairs.member[(4u + _e1204)]), _e1193.member);
                                atomicStore((&pairs.member[(_e1204 + 5u)]), _e1193.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1212 = atomicLoad((&shared_[13u]));
                            let _e1214 = (_e1212 + _e965[1]);
                            if (_e1214 < _e70.member_4) {
                                let _e1221 = (2u * ((_e70.member_5 * _e70.member_4) + _e1214));
                                front.member[_e1221] = _e918.member[0];
                                front.member[(_e1221 + 1u)] = _e918.member[1];
                            }
                        }
                    }
                }
                if (_e916.member_1 == 1u) {
                    let _e1318 = atomicLoad((&shared_[10u]));
                    if (_e988[0] < _e1318) {
                        let _e1338 = atomicLoad((&shared_[9u]));
                        let _e1341 = (2u * (_e1338 + _e988[0]));
                        stack[_e1341] = _e916.member[0];
                        stack[(_e1341 + 1u)] = _e916.member[1];
                    } else {
                        let _e1322 = atomicLoad((&shared_[11u]));
                        let _e1325 = ((_e1322 + _e988[0]) - _e1318);
                        if (_e1325 < _e70.member_3) {
                            let _e1328 = (_e83 + _e1325);
                            if (_e1328 < 4294967295u) {
                                let _e1332 = (2u * _e1328);
                                atomicStore((&nodes.member[(4u + _e1332)]), _e916.member[0]);
                                atomicStore((&nodes.member[(_e1332 + 5u)]), _e916.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e916.member_1 == 0u) {
                    } else {
                        if (_e916.member_1 == 2u) {
                            let _e1266 = a.member[_e916.member[0]];
                            let _e1270 = b.member[_e916.member[1]];
                            let _e1274 = params.member.member_2.member;
                            if (_e1274 == 1u) {
                                if (_e1266.member_1 < _e1270.member_1) {
                                    phi_2025_ = type_9(_e1266.member_1, _e1270.member_1);
                                } else {
                                    phi_2025_ = type_9(_e1270.member_1, _e1266.member_1);
                                }
                                let _e1281 = phi_2025_;
                                phi_2030_ = _e1281;
                            } else {
                                phi_2030_ = type_9(_e1266.member_1, _e1270.member_1);
                            }
                            let _e1283 = phi_2030_;
                            let _e1287 = params.member.member_1;
                            let _e1290 = atomicLoad((&shared_[12u]));
                            let _e1292 = (_e1290 + _e988[0]);
                            if (_e1292 < _e1287.member_3) {
                                let _e1294 = (2u * _e1292);
                                atomicStore((&pairs.member[(4u + _e1294)]), _e1283.member);
                                atomicStore((&pairs.member[(_e1294 + 5u)]), _e1283.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1302 = atomicLoad((&shared_[13u]));
                            let _e1304 = (_e1302 + _e988[1]);
                            if (_e1304 < _e70.member_4) {
                                let _e1311 = (2u * ((_e70.member_5 * _e70.member_4) + _e1304));
                                front.member[_e1311] = _e916.member[0];
                                front.member[(_e1311 + 1u)] = _e916.member[1];
                            }
                        }
                    }
                }
                if (_e914.member_1 == 1u) {
                    let _e1408 = atomicLoad((&shared_[10u]));
                    if (_e1011[0] < _e1408) {
                        let _e1428 = atomicLoad((&shared_[9u]));
                        let _e1431 = (2u * (_e1428 + _e1011[0]));
                        stack[_e1431] = _e914.member[0];
                        stack[(_e1431 + 1u)] = _e914.member[1];
                    } else {
                        let _e1412 = atomicLoad((&shared_[11u]));
                        let _e1415 = ((_e1412 + _e1011[0]) - _e1408);
                        if (_e1415 < _e70.member_3) {
                            let _e1418 = (_e83 + _e1415);
                            if (_e1418 < 4294967295u) {
                                let _e1422 = (2u * _e1418);
                                atomicStore((&nodes.member[(4u + _e1422)]), _e914.member[0]);
                                atomicStore((&nodes.member[(_e1422 + 5u)]), _e914.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e914.member_1 == 0u) {
                    } else {
                        if (_e914.member_1 == 2u) {
                            let _e1356 = a.member[_e914.member[0]];
                            let _e1360 = b.member[_e914.member[1]];
                            let _e1364 = params.member.member_2.member;
                            if (_e1364 == 1u) {
                                if (_e1356.member_1 < _e1360.member_1) {
                                    phi_2188_ = type_9(_e1356.member_1, _e1360.member_1);
                                } else {
                                    phi_2188_ = type_9(_e1360.member_1, _e1356.member_1);
                                }
                                let _e1371 = phi_2188_;
                                phi_2193_ = _e1371;
                            } else {
                                phi_2193_ = type_9(_e1356.member_1, _e1360.member_1);
                            }
                            let _e1373 = phi_2193_;
                            let _e1377 = params.member.member_1;
                            let _e1380 = atomicLoad((&shared_[12u]));
                            let _e1382 = (_e1380 + _e1011[0]);
                            if (_e1382 < _e1377.member_3) {
                                let _e1384 = (2u * _e1382);
                                atomicStore((&pairs.member[(4u + _e1384)]), _e1373.member);
                                atomicStore((&pairs.member[(_e1384 + 5u)]), _e1373.member_1);
                            }
                        }
                        if (_e70.member_4 > 0u) {
                            let _e1392 = atomicLoad((&shared_[13u]));
                            let _e1394 = (_e1392 + _e1011[1]);
                            if (_e1394 < _e70.member_4) {
                                let _e1401 = (2u * ((_e70.member_5 * _e70.member_4) + _e1394));
                                front.member[_e1401] = _e914.member[0];
                                front.member[(_e1401 + 1u)] = _e914.member[1];
                            }
                        }
                    }
                }
                phi_2246_ = true;
            }
            let _e1438 = phi_2246_;
            phi_2247_ = _e1438;
        } else {
            phi_2247_ = false;
        }
        let _e1440 = phi_2247_;
        continue;
        continuing {
            phi_204_ = _e104;
            break if !(_e1440);
        }
    }
    if (_e56 == 0u) {
        if (_e70.member_6 == 0u) {
            if (_e68 < _e80) {
                phi_2270_ = ((((_e80 - 1u) - _e68) >> bitcast<u32>((_e70.member_7 & 31u))) + 1u);
            } else {
                phi_2270_ = 0u;
            }
            let _e1454 = phi_2270_;
            let _e1456 = atomicLoad((&shared_[5u]));
            phi_2275_ = (_e1454 - _e1456);
        } else {
            phi_2275_ = 0u;
        }
        let _e1459 = phi_2275_;
        atomicStore((&shared_[14u]), _e1459);
        let _e1462 = atomicLoad((&shared_[0u]));
        let _e1463 = (_e1462 + _e1459);
        if (_e1463 > 0u) {
            if (_e70.member_12 == 0u) {
            } else {
                let _e1468 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e1471 = atomicAdd((&control.member[(_e72.member_1 + 1u)]), _e1463);
            let _e1474 = atomicMax((&nodes.member[0u]), (_e1471 + _e1463));
            if ((_e1471 + _e1463) < _e1471) {
                let _e1478 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e1471);
        }
        let _e1483 = atomicLoad((&shared_[15u]));
        let _e1485 = atomicAdd((&control.member[(1540u + (2u * _e68))]), _e1483);
        let _e1489 = atomicLoad((&shared_[16u]));
        let _e1491 = atomicAdd((&control.member[((2u * _e68) + 1541u)]), _e1489);
    }
    workgroupBarrier();
    let _e1493 = atomicLoad((&shared_[0u]));
    let _e1495 = atomicLoad((&shared_[17u]));
    let _e1497 = atomicLoad((&shared_[14u]));
    phi_2348_ = type_9(0u, 8u);
    loop {
        let _e1499 = phi_2348_;
        if (_e1499.member < _e1499.member_1) {
            phi_2349_ = type_9((_e1499.member + 1u), _e1499.member_1);
            phi_2372_ = type_9(1u, _e1499.member);
        } else {
            phi_2349_ = _e1499;
            phi_2372_ = type_9(0u, type_9().member_1);
        }
        let _e1511 = phi_2349_;
        let _e1513 = phi_2372_;
        let _e1517 = (bitcast<i32>(_e1513.member) != 0i);
        if _e1517 {
            let _e1519 = ((_e1513.member_1 * 128u) + _e56);
            if (_e1519 < _e1493) {
                let _e1523 = stack[(2u * _e1519)];
                let _e1527 = stack[((2u * _e1519) + 1u)];
                let _e1528 = (_e1495 + _e1519);
                if (_e1528 < _e70.member_3) {
                    let _e1531 = (_e83 + _e1528);
                    if (_e1531 < 4294967295u) {
                        let _e1533 = (2u * _e1531);
                        atomicStore((&nodes.member[(4u + _e1533)]), _e1523);
                        atomicStore((&nodes.member[(_e1533 + 5u)]), _e1527);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2348_ = _e1511;
            break if !(_e1517);
        }
    }
    let _e1540 = atomicLoad((&shared_[5u]));
    let _e1541 = (_e1497 / 128u);
    if ((_e1497 % 128u) > 0u) {
        phi_2432_ = (_e1541 + 1u);
    } else {
        phi_2432_ = _e1541;
    }
    let _e1546 = phi_2432_;
    phi_2435_ = type_9(0u, _e1546);
    loop {
        let _e1549 = phi_2435_;
        if (_e1549.member < _e1549.member_1) {
            phi_2436_ = type_9((_e1549.member + 1u), _e1549.member_1);
            phi_2459_ = type_9(1u, _e1549.member);
        } else {
            phi_2436_ = _e1549;
            phi_2459_ = type_9(0u, type_9().member_1);
        }
        let _e1561 = phi_2436_;
        let _e1563 = phi_2459_;
        let _e1567 = (bitcast<i32>(_e1563.member) != 0i);
        if _e1567 {
            let _e1569 = ((_e1563.member_1 * 128u) + _e56);
            if (_e1569 < _e1497) {
                let _e1578 = (2u * ((_e81 + _e68) + ((_e1540 + _e1569) << bitcast<u32>((_e70.member_7 & 31u)))));
                let _e1581 = atomicLoad((&nodes.member[(4u + _e1578)]));
                let _e1584 = atomicLoad((&nodes.member[(_e1578 + 5u)]));
                let _e1586 = ((_e1495 + _e1493) + _e1569);
                if (_e1586 < _e70.member_3) {
                    let _e1589 = (_e83 + _e1586);
                    if (_e1589 < 4294967295u) {
                        let _e1591 = (2u * _e1589);
                        atomicStore((&nodes.member[(4u + _e1591)]), _e1581);
                        atomicStore((&nodes.member[(_e1591 + 5u)]), _e1584);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2435_ = _e1561;
            break if !(_e1567);
        }
    }
    if (_e70.member_6 == 1u) {
        if (_e1540 == 0u) {
            phi_2540_ = type_9(0u, _e80);
            loop {
                let _e1602 = phi_2540_;
                if (_e1602.member < _e1602.member_1) {
                    phi_2541_ = type_9((_e1602.member + 1u), _e1602.member_1);
                    phi_2564_ = type_9(1u, _e1602.member);
                } else {
                    phi_2541_ = _e1602;
                    phi_2564_ = type_9(0u, type_9().member_1);
                }
                let _e1614 = phi_2541_;
                let _e1616 = phi_2564_;
                if (bitcast<i32>(_e1616.member) != 0i) {
                    let _e1622 = atomicAdd((&control.member[(512u + _e72.member_1)]), 1u);
                    if (_e1622 >= _e80) {
                        phi_2656_ = false;
                    } else {
                        let _e1625 = (2u * (_e81 + _e1622));
                        let _e1628 = atomicLoad((&nodes.member[(4u + _e1625)]));
                        let _e1631 = atomicLoad((&nodes.member[(_e1625 + 5u)]));
                        if (_e70.member_12 == 0u) {
                        } else {
                            let _e1635 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1638 = atomicAdd((&control.member[(_e72.member_1 + 1u)]), 1u);
                        let _e1641 = atomicMax((&nodes.member[0u]), (_e1638 + 1u));
                        if ((_e1638 + 1u) < _e1638) {
                            let _e1645 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1638 < _e70.member_3) {
                            let _e1648 = (_e83 + _e1638);
                            if (_e1648 < 4294967295u) {
                                let _e1650 = (2u * _e1648);
                                atomicStore((&nodes.member[(4u + _e1650)]), _e1628);
                                atomicStore((&nodes.member[(_e1650 + 5u)]), _e1631);
                            }
                        }
                        phi_2656_ = true;
                    }
                    let _e1656 = phi_2656_;
                    phi_2657_ = _e1656;
                } else {
                    phi_2657_ = false;
                }
                let _e1658 = phi_2657_;
                continue;
                continuing {
                    phi_2540_ = _e1614;
                    break if !(_e1658);
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
