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
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
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

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_25 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(4) 
var<storage, read_write> levels: type_25;
@group(0) @binding(5) 
var<storage, read_write> output: type_25;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_25;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_109_: array<u32, 2>;
    var phi_135_: u32;
    var phi_153_: u32;
    var phi_173_: u32;
    var phi_176_: type_9;
    var phi_177_: type_9;
    var phi_200_: type_9;
    var phi_308_: array<u32, 2>;
    var phi_322_: array<u32, 2>;
    var phi_359_: array<u32, 2>;
    var phi_361_: type_22;
    var phi_362_: type_22;
    var phi_363_: bool;
    var phi_364_: type_22;
    var phi_365_: bool;
    var phi_381_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_536_: array<u32, 2>;
    var phi_565_: array<u32, 2>;
    var phi_594_: array<u32, 2>;
    var phi_623_: array<u32, 2>;
    var phi_625_: type_22;
    var phi_626_: bool;
    var phi_627_: type_22;
    var phi_628_: bool;
    var phi_801_: array<u32, 2>;
    var phi_833_: array<u32, 2>;
    var phi_701_: array<u32, 2>;
    var phi_733_: array<u32, 2>;
    var phi_835_: type_22;
    var phi_836_: type_22;
    var phi_837_: type_22;
    var phi_838_: bool;
    var phi_839_: type_22;
    var phi_840_: type_22;
    var phi_841_: bool;
    var phi_845_: type_22;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_868_: u32;
    var phi_869_: u32;
    var phi_875_: array<u32, 2>;
    var phi_876_: array<u32, 2>;
    var phi_877_: array<u32, 2>;
    var phi_878_: array<u32, 2>;
    var phi_879_: array<u32, 2>;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_900_: u32;
    var phi_901_: u32;
    var phi_910_: u32;
    var phi_913_: u32;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_934_: u32;
    var phi_935_: u32;
    var phi_944_: u32;
    var phi_947_: u32;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_968_: u32;
    var phi_969_: u32;
    var phi_978_: u32;
    var phi_981_: u32;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_1002_: u32;
    var phi_1003_: u32;
    var phi_1012_: u32;
    var phi_1015_: u32;
    var phi_1081_: bool;
    var phi_1082_: bool;
    var phi_1086_: u32;
    var phi_1087_: u32;
    var phi_1150_: type_9;
    var phi_1155_: type_9;
    var phi_1188_: bool;
    var phi_1189_: bool;
    var phi_1193_: u32;
    var phi_1194_: u32;
    var phi_1257_: type_9;
    var phi_1262_: type_9;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1300_: u32;
    var phi_1301_: u32;
    var phi_1364_: type_9;
    var phi_1369_: type_9;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1407_: u32;
    var phi_1408_: u32;
    var phi_1471_: type_9;
    var phi_1476_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e28 = id_2;
    let _e29 = n_2;
    let _e30 = lane_2;
    let _e45 = (_e29.x * _e29.y);
    let _e48 = params.member.member_2.member;
    let _e51 = params.member.member_1.member_1;
    let _e54 = params.member.member_2.member;
    if (_e54 == 0u) {
        phi_109_ = array<u32, 2>(0u, 2u);
    } else {
        phi_109_ = array<u32, 2>(1u, 1u);
    }
    let _e57 = phi_109_;
    let _e63 = params.member.member.member[_e57[0]];
    let _e64 = (_e63 - 1u);
    let _e68 = params.member.member.member[_e57[1]];
    let _e69 = (_e68 - 1u);
    let _e72 = params.member.member_2.member_1;
    if (_e72 == 0u) {
        phi_135_ = 1u;
    } else {
        phi_135_ = 0u;
    }
    let _e75 = phi_135_;
    let _e77 = atomicLoad((&levels.member[_e51]));
    let _e80 = params.member.member_1.member_2;
    if (_e80 < _e77) {
        phi_153_ = _e80;
    } else {
        phi_153_ = _e77;
    }
    let _e83 = phi_153_;
    let _e86 = params.member.member_1.member_2;
    let _e87 = (_e45 * 128u);
    if (_e87 == 0u) {
        return;
    }
    let _e89 = (_e86 / _e87);
    if (_e87 == 0u) {
        return;
    }
    if ((_e86 % _e87) > 0u) {
        phi_173_ = (_e89 + 1u);
    } else {
        phi_173_ = _e89;
    }
    let _e95 = phi_173_;
    phi_176_ = type_9(0u, _e95);
    loop {
        let _e98 = phi_176_;
        if (_e98.member < _e98.member_1) {
            phi_177_ = type_9((_e98.member + 1u), _e98.member_1);
            phi_200_ = type_9(1u, _e98.member);
        } else {
            phi_177_ = _e98;
            phi_200_ = type_9(0u, type_9().member_1);
        }
        let _e110 = phi_177_;
        let _e112 = phi_200_;
        let _e116 = (bitcast<i32>(_e112.member) != 0i);
        if _e116 {
            let _e120 = (((((_e28.y * _e29.x) + _e28.x) + (_e112.member_1 * _e45)) * 128u) + _e30);
            if (_e30 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e120 < _e83) {
                let _e125 = (2u * _e120);
                let _e128 = input.member[(4u + _e125)];
                let _e131 = input.member[(_e125 + 5u)];
                let _e134 = a_nodes.member[_e128];
                let _e136 = b_nodes.member[_e131];
                if (_e48 == 1u) {
                    if (_e128 == _e131) {
                        if (_e134.member_3 == 4294967295u) {
                            phi_361_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e142 = a_nodes.member[_e134.member_1];
                            let _e145 = a_nodes.member[_e134.member_3];
                            if !((_e142.member_3 == 4294967295u)) {
                                phi_308_ = array<u32, 2>(_e134.member_1, _e134.member_1);
                            } else {
                                phi_308_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e152 = phi_308_;
                            let _e159 = type_22(array<array<u32, 2>, 4>(_e152, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e171 = type_22(array<array<u32, 2>, 4>(_e159.member[0], array<u32, 2>(_e134.member_1, _e159.member[1][1]), _e159.member[2], _e159.member[3]), _e159.member_1);
                            let _e172 = array<u32, 2>(_e134.member_1, _e134.member_3);
                            let _e179 = type_22(array<array<u32, 2>, 4>(_e171.member[0], _e172, _e171.member[2], _e171.member[3]), _e171.member_1);
                            if !((_e145.member_3 == 4294967295u)) {
                                phi_322_ = array<u32, 2>(_e134.member_3, _e134.member_3);
                            } else {
                                phi_322_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e186 = phi_322_;
                            let _e193 = type_22(array<array<u32, 2>, 4>(_e179.member[0], _e179.member[1], _e186, _e179.member[3]), _e179.member_1);
                            let _e196 = type_22(_e193.member, _e193.member);
                            if ((((((_e142.member[0] <= _e145.member_2[0]) && (_e145.member[0] <= _e142.member_2[0])) && (_e142.member[1] <= _e145.member_2[1])) && (_e145.member[1] <= _e142.member_2[1])) && (_e142.member[2] <= _e145.member_2[2])) && (_e145.member[2] <= _e142.member_2[2])) {
                                phi_359_ = _e172;
                            } else {
                                phi_359_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e225 = phi_359_;
                            phi_361_ = type_22(_e196.member, array<array<u32, 2>, 4>(_e196.member_1[0], _e225, _e196.member_1[2], _e196.member_1[3]));
                        }
                        let _e234 = phi_361_;
                        phi_362_ = _e234;
                        phi_363_ = false;
                    } else {
                        phi_362_ = type_22();
                        phi_363_ = true;
                    }
                    let _e236 = phi_362_;
                    let _e238 = phi_363_;
                    phi_364_ = _e236;
                    phi_365_ = _e238;
                } else {
                    phi_364_ = type_22();
                    phi_365_ = true;
                }
                let _e240 = phi_364_;
                let _e242 = phi_365_;
                if _e242 {
                    let _e245 = !((_e134.member_3 == 4294967295u));
                    let _e248 = !((_e136.member_3 == 4294967295u));
                    if _e245 {
                        phi_381_ = true;
                    } else {
                        phi_381_ = _e248;
                    }
                    let _e250 = phi_381_;
                    if _e250 {
                        if _e245 {
                            if _e248 {
                                if (_e75 == 0u) {
                                    let _e278 = ((((_e136.member_2[0] - _e136.member[0]) * (_e136.member_2[1] - _e136.member[1])) * (_e136.member_2[2] - _e136.member[2])) > (((_e134.member_2[0] - _e134.member[0]) * (_e134.member_2[1] - _e134.member[1])) * (_e134.member_2[2] - _e134.member[2])));
                                    phi_425_ = _e278;
                                    phi_426_ = !(_e278);
                                } else {
                                    phi_425_ = _e248;
                                    phi_426_ = _e245;
                                }
                                let _e281 = phi_425_;
                                let _e283 = phi_426_;
                                phi_427_ = _e281;
                                phi_428_ = _e283;
                            } else {
                                phi_427_ = _e248;
                                phi_428_ = _e245;
                            }
                            let _e285 = phi_427_;
                            let _e287 = phi_428_;
                            phi_429_ = _e285;
                            phi_430_ = _e287;
                        } else {
                            phi_429_ = _e248;
                            phi_430_ = _e245;
                        }
                        let _e289 = phi_429_;
                        let _e291 = phi_430_;
                        if _e291 {
                            if _e289 {
                                let _e294 = a_nodes.member[_e134.member_1];
                                let _e299 = a_nodes.member[_e134.member_3];
                                let _e304 = b_nodes.member[_e136.member_1];
                                let _e309 = b_nodes.member[_e136.member_3];
                                let _e314 = array<u32, 2>(_e134.member_1, _e136.member_1);
                                let _e317 = array<u32, 2>(_e134.member_1, _e136.member_3);
                                let _e320 = array<u32, 2>(_e134.member_3, _e136.member_1);
                                let _e323 = array<u32, 2>(_e134.member_3, _e136.member_3);
                                if ((((((_e294.member[0] <= _e304.member_2[0]) && (_e304.member[0] <= _e294.member_2[0])) && (_e294.member[1] <= _e304.member_2[1])) && (_e304.member[1] <= _e294.member_2[1])) && (_e294.member[2] <= _e304.member_2[2])) && (_e304.member[2] <= _e294.member_2[2])) {
                                    phi_536_ = _e314;
                                } else {
                                    phi_536_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e349 = phi_536_;
                                if ((((((_e294.member[0] <= _e309.member_2[0]) && (_e309.member[0] <= _e294.member_2[0])) && (_e294.member[1] <= _e309.member_2[1])) && (_e309.member[1] <= _e294.member_2[1])) && (_e294.member[2] <= _e309.member_2[2])) && (_e309.member[2] <= _e294.member_2[2])) {
                                    phi_565_ = _e317;
                                } else {
                                    phi_565_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e374 = phi_565_;
                                if ((((((_e299.member[0] <= _e304.member_2[0]) && (_e304.member[0] <= _e299.member_2[0])) && (_e299.member[1] <= _e304.member_2[1])) && (_e304.member[1] <= _e299.member_2[1])) && (_e299.member[2] <= _e304.member_2[2])) && (_e304.member[2] <= _e299.member_2[2])) {
                                    phi_594_ = _e320;
                                } else {
                                    phi_594_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e399 = phi_594_;
                                if ((((((_e299.member[0] <= _e309.member_2[0]) && (_e309.member[0] <= _e299.member_2[0])) && (_e299.member[1] <= _e309.member_2[1])) && (_e309.member[1] <= _e299.member_2[1])) && (_e299.member[2] <= _e309.member_2[2])) && (_e309.member[2] <= _e299.member_2[2])) {
                                    phi_623_ = _e323;
                                } else {
                                    phi_623_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e424 = phi_623_;
                                phi_625_ = type_22(array<array<u32, 2>, 4>(_e314, _e317, _e320, _e323), array<array<u32, 2>, 4>(_e349, _e374, _e399, _e424));
                                phi_626_ = false;
                            } else {
                                phi_625_ = type_22();
                                phi_626_ = true;
                            }
                            let _e428 = phi_625_;
                            let _e430 = phi_626_;
                            phi_627_ = _e428;
                            phi_628_ = _e430;
                        } else {
                            phi_627_ = type_22();
                            phi_628_ = true;
                        }
                        let _e432 = phi_627_;
                        let _e434 = phi_628_;
                        if _e434 {
                            if _e291 {
                                let _e533 = a_nodes.member[_e134.member_1];
                                let _e538 = a_nodes.member[_e134.member_3];
                                let _e542 = array<u32, 2>(_e134.member_1, _e131);
                                let _e544 = array<u32, 2>(_e134.member_3, _e131);
                                let _e551 = type_22(array<array<u32, 2>, 4>(_e542, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e558 = type_22(array<array<u32, 2>, 4>(_e551.member[0], _e544, _e551.member[2], _e551.member[3]), _e551.member_1);
                                if ((((((_e533.member[0] <= _e136.member_2[0]) && (_e136.member[0] <= _e533.member_2[0])) && (_e533.member[1] <= _e136.member_2[1])) && (_e136.member[1] <= _e533.member_2[1])) && (_e533.member[2] <= _e136.member_2[2])) && (_e136.member[2] <= _e533.member_2[2])) {
                                    phi_701_ = _e542;
                                } else {
                                    phi_701_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e585 = phi_701_;
                                let _e592 = type_22(_e558.member, array<array<u32, 2>, 4>(_e585, _e558.member_1[1], _e558.member_1[2], _e558.member_1[3]));
                                if ((((((_e538.member[0] <= _e136.member_2[0]) && (_e136.member[0] <= _e538.member_2[0])) && (_e538.member[1] <= _e136.member_2[1])) && (_e136.member[1] <= _e538.member_2[1])) && (_e538.member[2] <= _e136.member_2[2])) && (_e136.member[2] <= _e538.member_2[2])) {
                                    phi_733_ = _e544;
                                } else {
                                    phi_733_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e619 = phi_733_;
                                phi_835_ = type_22(_e592.member, array<array<u32, 2>, 4>(_e592.member_1[0], _e619, _e592.member_1[2], _e592.member_1[3]));
                            } else {
                                let _e437 = b_nodes.member[_e136.member_1];
                                let _e442 = b_nodes.member[_e136.member_3];
                                let _e446 = array<u32, 2>(_e128, _e136.member_1);
                                let _e448 = array<u32, 2>(_e128, _e136.member_3);
                                let _e455 = type_22(array<array<u32, 2>, 4>(_e446, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e462 = type_22(array<array<u32, 2>, 4>(_e455.member[0], _e448, _e455.member[2], _e455.member[3]), _e455.member_1);
                                if ((((((_e134.member[0] <= _e437.member_2[0]) && (_e437.member[0] <= _e134.member_2[0])) && (_e134.member[1] <= _e437.member_2[1])) && (_e437.member[1] <= _e134.member_2[1])) && (_e134.member[2] <= _e437.member_2[2])) && (_e437.member[2] <= _e134.member_2[2])) {
                                    phi_801_ = _e446;
                                } else {
                                    phi_801_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e489 = phi_801_;
                                let _e496 = type_22(_e462.member, array<array<u32, 2>, 4>(_e489, _e462.member_1[1], _e462.member_1[2], _e462.member_1[3]));
                                if ((((((_e134.member[0] <= _e442.member_2[0]) && (_e442.member[0] <= _e134.member_2[0])) && (_e134.member[1] <= _e442.member_2[1])) && (_e442.member[1] <= _e134.member_2[1])) && (_e134.member[2] <= _e442.member_2[2])) && (_e442.member[2] <= _e134.member_2[2])) {
                                    phi_833_ = _e448;
                                } else {
                                    phi_833_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e523 = phi_833_;
                                phi_835_ = type_22(_e496.member, array<array<u32, 2>, 4>(_e496.member_1[0], _e523, _e496.member_1[2], _e496.member_1[3]));
                            }
                            let _e628 = phi_835_;
                            phi_836_ = _e628;
                        } else {
                            phi_836_ = _e432;
                        }
                        let _e630 = phi_836_;
                        phi_837_ = _e630;
                        phi_838_ = false;
                    } else {
                        phi_837_ = type_22();
                        phi_838_ = true;
                    }
                    let _e632 = phi_837_;
                    let _e634 = phi_838_;
                    phi_839_ = _e632;
                    phi_840_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_841_ = _e634;
                } else {
                    phi_839_ = type_22();
                    phi_840_ = _e240;
                    phi_841_ = true;
                }
                let _e636 = phi_839_;
                let _e638 = phi_840_;
                let _e640 = phi_841_;
                if _e640 {
                    phi_845_ = _e638;
                } else {
                    phi_845_ = _e636;
                }
                let _e642 = phi_845_;
                if (_e128 == 4294967295u) {
                    phi_869_ = 0u;
                } else {
                    if (_e128 >= _e64) {
                        if (_e131 >= _e69) {
                            phi_863_ = false;
                        } else {
                            phi_863_ = true;
                        }
                        let _e652 = phi_863_;
                        phi_864_ = _e652;
                    } else {
                        phi_864_ = true;
                    }
                    let _e654 = phi_864_;
                    if _e654 {
                        phi_868_ = 1u;
                    } else {
                        phi_868_ = 2u;
                    }
                    let _e656 = phi_868_;
                    phi_869_ = _e656;
                }
                let _e658 = phi_869_;
                if (_e658 == 2u) {
                    phi_875_ = array<u32, 2>(_e128, _e131);
                } else {
                    phi_875_ = _e642.member_1[0];
                }
                let _e662 = phi_875_;
                phi_876_ = _e642.member_1[3];
                phi_877_ = _e642.member_1[2];
                phi_878_ = _e642.member_1[1];
                phi_879_ = _e662;
            } else {
                phi_876_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_877_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_878_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_879_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e664 = phi_876_;
            let _e666 = phi_877_;
            let _e668 = phi_878_;
            let _e670 = phi_879_;
            if (_e670[0] == 4294967295u) {
                phi_901_ = 0u;
            } else {
                if (_e670[0] >= _e64) {
                    if (_e670[1] >= _e69) {
                        phi_895_ = false;
                    } else {
                        phi_895_ = true;
                    }
                    let _e678 = phi_895_;
                    phi_896_ = _e678;
                } else {
                    phi_896_ = true;
                }
                let _e680 = phi_896_;
                if _e680 {
                    phi_900_ = 1u;
                } else {
                    phi_900_ = 2u;
                }
                let _e682 = phi_900_;
                phi_901_ = _e682;
            }
            let _e684 = phi_901_;
            if (_e684 == 0u) {
                phi_913_ = 0u;
            } else {
                if (_e684 == 1u) {
                    phi_910_ = 0u;
                } else {
                    phi_910_ = 1u;
                }
                let _e688 = phi_910_;
                let _e690 = atomicAdd((&counters[_e688]), 1u);
                phi_913_ = _e690;
            }
            let _e692 = phi_913_;
            if (_e668[0] == 4294967295u) {
                phi_935_ = 0u;
            } else {
                if (_e668[0] >= _e64) {
                    if (_e668[1] >= _e69) {
                        phi_929_ = false;
                    } else {
                        phi_929_ = true;
                    }
                    let _e700 = phi_929_;
                    phi_930_ = _e700;
                } else {
                    phi_930_ = true;
                }
                let _e702 = phi_930_;
                if _e702 {
                    phi_934_ = 1u;
                } else {
                    phi_934_ = 2u;
                }
                let _e704 = phi_934_;
                phi_935_ = _e704;
            }
            let _e706 = phi_935_;
            if (_e706 == 0u) {
                phi_947_ = 0u;
            } else {
                if (_e706 == 1u) {
                    phi_944_ = 0u;
                } else {
                    phi_944_ = 1u;
                }
                let _e710 = phi_944_;
                let _e712 = atomicAdd((&counters[_e710]), 1u);
                phi_947_ = _e712;
            }
            let _e714 = phi_947_;
            if (_e666[0] == 4294967295u) {
                phi_969_ = 0u;
            } else {
                if (_e666[0] >= _e64) {
                    if (_e666[1] >= _e69) {
                        phi_963_ = false;
                    } else {
                        phi_963_ = true;
                    }
                    let _e722 = phi_963_;
                    phi_964_ = _e722;
                } else {
                    phi_964_ = true;
                }
                let _e724 = phi_964_;
                if _e724 {
                    phi_968_ = 1u;
                } else {
                    phi_968_ = 2u;
                }
                let _e726 = phi_968_;
                phi_969_ = _e726;
            }
            let _e728 = phi_969_;
            if (_e728 == 0u) {
                phi_981_ = 0u;
            } else {
                if (_e728 == 1u) {
                    phi_978_ = 0u;
                } else {
                    phi_978_ = 1u;
                }
                let _e732 = phi_978_;
                let _e734 = atomicAdd((&counters[_e732]), 1u);
                phi_981_ = _e734;
            }
            let _e736 = phi_981_;
            if (_e664[0] == 4294967295u) {
                phi_1003_ = 0u;
            } else {
                if (_e664[0] >= _e64) {
                    if (_e664[1] >= _e69) {
                        phi_997_ = false;
                    } else {
                        phi_997_ = true;
                    }
                    let _e744 = phi_997_;
                    phi_998_ = _e744;
                } else {
                    phi_998_ = true;
                }
                let _e746 = phi_998_;
                if _e746 {
                    phi_1002_ = 1u;
                } else {
                    phi_1002_ = 2u;
                }
                let _e748 = phi_1002_;
                phi_1003_ = _e748;
            }
            let _e750 = phi_1003_;
            if (_e750 == 0u) {
                phi_1015_ = 0u;
            } else {
                if (_e750 == 1u) {
                    phi_1012_ = 0u;
                } else {
                    phi_1012_ = 1u;
                }
                let _e754 = phi_1012_;
                let _e756 = atomicAdd((&counters[_e754]), 1u);
                phi_1015_ = _e756;
            }
            let _e758 = phi_1015_;
            workgroupBarrier();
            if (_e30 == 0u) {
                let _e761 = atomicLoad((&counters[0u]));
                let _e763 = atomicLoad((&counters[1u]));
                if (_e761 > 0u) {
                    let _e767 = atomicAdd((&levels.member[(_e51 + 1u)]), _e761);
                    let _e770 = atomicMax((&output.member[0u]), (_e767 + _e761));
                    if ((_e767 + _e761) < _e767) {
                        let _e774 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e767);
                }
                if (_e763 > 0u) {
                    let _e778 = atomicAdd((&pairs.member[0u]), _e763);
                    if ((_e778 + _e763) < _e778) {
                        let _e782 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e778);
                }
            }
            workgroupBarrier();
            let _e785 = atomicLoad((&counters[2u]));
            let _e787 = atomicLoad((&counters[3u]));
            if (_e670[0] == 4294967295u) {
                phi_1087_ = 0u;
            } else {
                if (_e670[0] >= _e64) {
                    if (_e670[1] >= _e69) {
                        phi_1081_ = false;
                    } else {
                        phi_1081_ = true;
                    }
                    let _e795 = phi_1081_;
                    phi_1082_ = _e795;
                } else {
                    phi_1082_ = true;
                }
                let _e797 = phi_1082_;
                if _e797 {
                    phi_1086_ = 1u;
                } else {
                    phi_1086_ = 2u;
                }
                let _e799 = phi_1086_;
                phi_1087_ = _e799;
            }
            let _e801 = phi_1087_;
            if (_e801 == 1u) {
                let _e840 = params.member.member_2.member_3;
                let _e841 = (_e785 + _e692);
                if (_e841 < _e840) {
                    let _e843 = (2u * _e841);
                    atomicStore((&output.member[(4u + _e843)]), _e670[0]);
                    atomicStore((&output.member[(_e843 + 5u)]), _e670[1]);
                }
            } else {
                if (_e801 == 2u) {
                    let _e806 = a_nodes.member[_e670[0]];
                    let _e810 = b_nodes.member[_e670[1]];
                    let _e814 = params.member.member_2.member;
                    if (_e814 == 1u) {
                        if (_e806.member_1 < _e810.member_1) {
                            phi_1150_ = type_9(_e806.member_1, _e810.member_1);
                        } else {
                            phi_1150_ = type_9(_e810.member_1, _e806.member_1);
                        }
                        let _e821 = phi_1150_;
                        phi_1155_ = _e821;
                    } else {
                        phi_1155_ = type_9(_e806.member_1, _e810.member_1);
                    }
                    let _e823 = phi_1155_;
                    let _e826 = params.member.member_1.member_3;
                    let _e827 = (_e787 + _e692);
                    if (_e827 < _e826) {
                        let _e831 = (2u * _e827);
                        atomicStore((&pairs.member[(4u + _e831)]), _e823.member);
                        atomicStore((&pairs.member[(_e831 + 5u)]), _e823.member_1);
                    }
                }
            }
            if (_e668[0] == 4294967295u) {
                phi_1194_ = 0u;
            } else {
                if (_e668[0] >= _e64) {
                    if (_e668[1] >= _e69) {
                        phi_1188_ = false;
                    } else {
                        phi_1188_ = true;
                    }
                    let _e855 = phi_1188_;
                    phi_1189_ = _e855;
                } else {
                    phi_1189_ = true;
                }
                let _e857 = phi_1189_;
                if _e857 {
                    phi_1193_ = 1u;
                } else {
                    phi_1193_ = 2u;
                }
                let _e859 = phi_1193_;
                phi_1194_ = _e859;
            }
            let _e861 = phi_1194_;
            if (_e861 == 1u) {
                let _e900 = params.member.member_2.member_3;
                let _e901 = (_e785 + _e714);
                if (_e901 < _e900) {
                    let _e903 = (2u * _e901);
                    atomicStore((&output.member[(4u + _e903)]), _e668[0]);
                    atomicStore((&output.member[(_e903 + 5u)]), _e668[1]);
                }
            } else {
                if (_e861 == 2u) {
                    let _e866 = a_nodes.member[_e668[0]];
                    let _e870 = b_nodes.member[_e668[1]];
                    let _e874 = params.member.member_2.member;
                    if (_e874 == 1u) {
                        if (_e866.member_1 < _e870.member_1) {
                            phi_1257_ = type_9(_e866.member_1, _e870.member_1);
                        } else {
                            phi_1257_ = type_9(_e870.member_1, _e866.member_1);
                        }
                        let _e881 = phi_1257_;
                        phi_1262_ = _e881;
                    } else {
                        phi_1262_ = type_9(_e866.member_1, _e870.member_1);
                    }
                    let _e883 = phi_1262_;
                    let _e886 = params.member.member_1.member_3;
                    let _e887 = (_e787 + _e714);
                    if (_e887 < _e886) {
                        let _e891 = (2u * _e887);
                        atomicStore((&pairs.member[(4u + _e891)]), _e883.member);
                        atomicStore((&pairs.member[(_e891 + 5u)]), _e883.member_1);
                    }
                }
            }
            if (_e666[0] == 4294967295u) {
                phi_1301_ = 0u;
            } else {
                if (_e666[0] >= _e64) {
                    if (_e666[1] >= _e69) {
                        phi_1295_ = false;
                    } else {
                        phi_1295_ = true;
                    }
                    let _e915 = phi_1295_;
                    phi_1296_ = _e915;
                } else {
                    phi_1296_ = true;
                }
                let _e917 = phi_1296_;
                if _e917 {
                    phi_1300_ = 1u;
                } else {
                    phi_1300_ = 2u;
                }
                let _e919 = phi_1300_;
                phi_1301_ = _e919;
            }
            let _e921 = phi_1301_;
            if (_e921 == 1u) {
                let _e960 = params.member.member_2.member_3;
                let _e961 = (_e785 + _e736);
                if (_e961 < _e960) {
                    let _e963 = (2u * _e961);
                    atomicStore((&output.member[(4u + _e963)]), _e666[0]);
                    atomicStore((&output.member[(_e963 + 5u)]), _e666[1]);
                }
            } else {
                if (_e921 == 2u) {
                    let _e926 = a_nodes.member[_e666[0]];
                    let _e930 = b_nodes.member[_e666[1]];
                    let _e934 = params.member.member_2.member;
                    if (_e934 == 1u) {
                        if (_e926.member_1 < _e930.member_1) {
                            phi_1364_ = type_9(_e926.member_1, _e930.member_1);
                        } else {
                            phi_1364_ = type_9(_e930.member_1, _e926.member_1);
                        }
                        let _e941 = phi_1364_;
                        phi_1369_ = _e941;
                    } else {
                        phi_1369_ = type_9(_e926.member_1, _e930.member_1);
                    }
                    let _e943 = phi_1369_;
                    let _e946 = params.member.member_1.member_3;
                    let _e947 = (_e787 + _e736);
                    if (_e947 < _e946) {
                        let _e951 = (2u * _e947);
                        atomicStore((&pairs.member[(4u + _e951)]), _e943.member);
                        atomicStore((&pairs.member[(_e951 + 5u)]), _e943.member_1);
                    }
                }
            }
            if (_e664[0] == 4294967295u) {
                phi_1408_ = 0u;
            } else {
                if (_e664[0] >= _e64) {
                    if (_e664[1] >= _e69) {
                        phi_1402_ = false;
                    } else {
                        phi_1402_ = true;
                    }
                    let _e975 = phi_1402_;
                    phi_1403_ = _e975;
                } else {
                    phi_1403_ = true;
                }
                let _e977 = phi_1403_;
                if _e977 {
                    phi_1407_ = 1u;
                } else {
                    phi_1407_ = 2u;
                }
                let _e979 = phi_1407_;
                phi_1408_ = _e979;
            }
            let _e981 = phi_1408_;
            if (_e981 == 1u) {
                let _e1020 = params.member.member_2.member_3;
                let _e1021 = (_e785 + _e758);
                if (_e1021 < _e1020) {
                    let _e1023 = (2u * _e1021);
                    atomicStore((&output.member[(4u + _e1023)]), _e664[0]);
                    atomicStore((&output.member[(_e1023 + 5u)]), _e664[1]);
                }
            } else {
                if (_e981 == 2u) {
                    let _e986 = a_nodes.member[_e664[0]];
                    let _e990 = b_nodes.member[_e664[1]];
                    let _e994 = params.member.member_2.member;
                    if (_e994 == 1u) {
                        if (_e986.member_1 < _e990.member_1) {
                            phi_1471_ = type_9(_e986.member_1, _e990.member_1);
                        } else {
                            phi_1471_ = type_9(_e990.member_1, _e986.member_1);
                        }
                        let _e1001 = phi_1471_;
                        phi_1476_ = _e1001;
                    } else {
                        phi_1476_ = type_9(_e986.member_1, _e990.member_1);
                    }
                    let _e1003 = phi_1476_;
                    let _e1006 = params.member.member_1.member_3;
                    let _e1007 = (_e787 + _e758);
                    if (_e1007 < _e1006) {
                        let _e1011 = (2u * _e1007);
                        atomicStore((&pairs.member[(4u + _e1011)]), _e1003.member);
                        atomicStore((&pairs.member[(_e1011 + 5u)]), _e1003.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_176_ = _e110;
            break if !(_e116);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
