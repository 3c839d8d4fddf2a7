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
    member_18: u32,
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
@group(0) @binding(5) 
var<storage, read_write> output: type_25;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_25;
@group(0) @binding(4) 
var<storage, read_write> levels: type_25;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_117_: array<u32, 2>;
    var phi_155_: u32;
    var phi_175_: u32;
    var phi_178_: type_9;
    var phi_179_: type_9;
    var phi_202_: type_9;
    var phi_255_: u32;
    var phi_327_: array<u32, 2>;
    var phi_341_: array<u32, 2>;
    var phi_378_: array<u32, 2>;
    var phi_380_: type_22;
    var phi_381_: type_22;
    var phi_382_: bool;
    var phi_383_: type_22;
    var phi_384_: bool;
    var phi_400_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_555_: array<u32, 2>;
    var phi_584_: array<u32, 2>;
    var phi_613_: array<u32, 2>;
    var phi_642_: array<u32, 2>;
    var phi_644_: type_22;
    var phi_645_: bool;
    var phi_646_: type_22;
    var phi_647_: bool;
    var phi_820_: array<u32, 2>;
    var phi_852_: array<u32, 2>;
    var phi_720_: array<u32, 2>;
    var phi_752_: array<u32, 2>;
    var phi_854_: type_22;
    var phi_855_: type_22;
    var phi_856_: type_22;
    var phi_857_: bool;
    var phi_858_: type_22;
    var phi_859_: type_22;
    var phi_860_: bool;
    var phi_864_: type_22;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_887_: u32;
    var phi_888_: u32;
    var phi_894_: array<u32, 2>;
    var phi_895_: array<u32, 2>;
    var phi_896_: array<u32, 2>;
    var phi_897_: array<u32, 2>;
    var phi_898_: array<u32, 2>;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_919_: u32;
    var phi_920_: u32;
    var phi_929_: u32;
    var phi_932_: u32;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_963_: u32;
    var phi_966_: u32;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_987_: u32;
    var phi_988_: u32;
    var phi_997_: u32;
    var phi_1000_: u32;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1021_: u32;
    var phi_1022_: u32;
    var phi_1031_: u32;
    var phi_1034_: u32;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1105_: u32;
    var phi_1106_: u32;
    var phi_1180_: type_9;
    var phi_1185_: type_9;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1219_: u32;
    var phi_1220_: u32;
    var phi_1294_: type_9;
    var phi_1299_: type_9;
    var phi_1328_: bool;
    var phi_1329_: bool;
    var phi_1333_: u32;
    var phi_1334_: u32;
    var phi_1408_: type_9;
    var phi_1413_: type_9;
    var phi_1442_: bool;
    var phi_1443_: bool;
    var phi_1447_: u32;
    var phi_1448_: u32;
    var phi_1522_: type_9;
    var phi_1527_: type_9;
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
    let _e48 = params.member.member_1.member_1;
    let _e51 = params.member.member_2.member;
    if (_e51 == 0u) {
        phi_117_ = array<u32, 2>(0u, 2u);
    } else {
        phi_117_ = array<u32, 2>(1u, 1u);
    }
    let _e54 = phi_117_;
    let _e60 = params.member.member.member[_e54[0]];
    let _e61 = (_e60 - 1u);
    let _e65 = params.member.member.member[_e54[1]];
    let _e66 = (_e65 - 1u);
    let _e68 = atomicLoad((&levels.member[_e48]));
    let _e71 = params.member.member_1.member_2;
    if (_e71 < _e68) {
        phi_155_ = _e71;
    } else {
        phi_155_ = _e68;
    }
    let _e74 = phi_155_;
    let _e77 = params.member.member_1.member_2;
    let _e78 = (_e45 * 128u);
    if (_e78 == 0u) {
        return;
    }
    let _e80 = (_e77 / _e78);
    if (_e78 == 0u) {
        return;
    }
    if ((_e77 % _e78) > 0u) {
        phi_175_ = (_e80 + 1u);
    } else {
        phi_175_ = _e80;
    }
    let _e86 = phi_175_;
    phi_178_ = type_9(0u, _e86);
    loop {
        let _e89 = phi_178_;
        if (_e89.member < _e89.member_1) {
            phi_179_ = type_9((_e89.member + 1u), _e89.member_1);
            phi_202_ = type_9(1u, _e89.member);
        } else {
            phi_179_ = _e89;
            phi_202_ = type_9(0u, type_9().member_1);
        }
        let _e101 = phi_179_;
        let _e103 = phi_202_;
        let _e107 = (bitcast<i32>(_e103.member) != 0i);
        if _e107 {
            let _e111 = (((((_e28.y * _e29.x) + _e28.x) + (_e103.member_1 * _e45)) * 128u) + _e30);
            if (_e30 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e111 < _e74) {
                let _e116 = (2u * _e111);
                let _e119 = input.member[(4u + _e116)];
                let _e122 = input.member[(_e116 + 5u)];
                let _e125 = params.member.member_2.member_1;
                if (_e125 == 0u) {
                    phi_255_ = 1u;
                } else {
                    phi_255_ = 0u;
                }
                let _e128 = phi_255_;
                let _e131 = params.member.member_2.member;
                let _e134 = a_nodes.member[_e119];
                let _e136 = b_nodes.member[_e122];
                if (_e131 == 1u) {
                    if (_e119 == _e122) {
                        if (_e134.member_3 == 4294967295u) {
                            phi_380_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e142 = a_nodes.member[_e134.member_1];
                            let _e145 = a_nodes.member[_e134.member_3];
                            if !((_e142.member_3 == 4294967295u)) {
                                phi_327_ = array<u32, 2>(_e134.member_1, _e134.member_1);
                            } else {
                                phi_327_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e152 = phi_327_;
                            let _e159 = type_22(array<array<u32, 2>, 4>(_e152, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e171 = type_22(array<array<u32, 2>, 4>(_e159.member[0], array<u32, 2>(_e134.member_1, _e159.member[1][1]), _e159.member[2], _e159.member[3]), _e159.member_1);
                            let _e172 = array<u32, 2>(_e134.member_1, _e134.member_3);
                            let _e179 = type_22(array<array<u32, 2>, 4>(_e171.member[0], _e172, _e171.member[2], _e171.member[3]), _e171.member_1);
                            if !((_e145.member_3 == 4294967295u)) {
                                phi_341_ = array<u32, 2>(_e134.member_3, _e134.member_3);
                            } else {
                                phi_341_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e186 = phi_341_;
                            let _e193 = type_22(array<array<u32, 2>, 4>(_e179.member[0], _e179.member[1], _e186, _e179.member[3]), _e179.member_1);
                            let _e196 = type_22(_e193.member, _e193.member);
                            if ((((((_e142.member[0] <= _e145.member_2[0]) && (_e145.member[0] <= _e142.member_2[0])) && (_e142.member[1] <= _e145.member_2[1])) && (_e145.member[1] <= _e142.member_2[1])) && (_e142.member[2] <= _e145.member_2[2])) && (_e145.member[2] <= _e142.member_2[2])) {
                                phi_378_ = _e172;
                            } else {
                                phi_378_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e225 = phi_378_;
                            phi_380_ = type_22(_e196.member, array<array<u32, 2>, 4>(_e196.member_1[0], _e225, _e196.member_1[2], _e196.member_1[3]));
                        }
                        let _e234 = phi_380_;
                        phi_381_ = _e234;
                        phi_382_ = false;
                    } else {
                        phi_381_ = type_22();
                        phi_382_ = true;
                    }
                    let _e236 = phi_381_;
                    let _e238 = phi_382_;
                    phi_383_ = _e236;
                    phi_384_ = _e238;
                } else {
                    phi_383_ = type_22();
                    phi_384_ = true;
                }
                let _e240 = phi_383_;
                let _e242 = phi_384_;
                if _e242 {
                    let _e245 = !((_e134.member_3 == 4294967295u));
                    let _e248 = !((_e136.member_3 == 4294967295u));
                    if _e245 {
                        phi_400_ = true;
                    } else {
                        phi_400_ = _e248;
                    }
                    let _e250 = phi_400_;
                    if _e250 {
                        if _e245 {
                            if _e248 {
                                if (_e128 == 0u) {
                                    let _e278 = ((((_e136.member_2[0] - _e136.member[0]) * (_e136.member_2[1] - _e136.member[1])) * (_e136.member_2[2] - _e136.member[2])) > (((_e134.member_2[0] - _e134.member[0]) * (_e134.member_2[1] - _e134.member[1])) * (_e134.member_2[2] - _e134.member[2])));
                                    phi_444_ = _e278;
                                    phi_445_ = !(_e278);
                                } else {
                                    phi_444_ = _e248;
                                    phi_445_ = _e245;
                                }
                                let _e281 = phi_444_;
                                let _e283 = phi_445_;
                                phi_446_ = _e281;
                                phi_447_ = _e283;
                            } else {
                                phi_446_ = _e248;
                                phi_447_ = _e245;
                            }
                            let _e285 = phi_446_;
                            let _e287 = phi_447_;
                            phi_448_ = _e285;
                            phi_449_ = _e287;
                        } else {
                            phi_448_ = _e248;
                            phi_449_ = _e245;
                        }
                        let _e289 = phi_448_;
                        let _e291 = phi_449_;
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
                                    phi_555_ = _e314;
                                } else {
                                    phi_555_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e349 = phi_555_;
                                if ((((((_e294.member[0] <= _e309.member_2[0]) && (_e309.member[0] <= _e294.member_2[0])) && (_e294.member[1] <= _e309.member_2[1])) && (_e309.member[1] <= _e294.member_2[1])) && (_e294.member[2] <= _e309.member_2[2])) && (_e309.member[2] <= _e294.member_2[2])) {
                                    phi_584_ = _e317;
                                } else {
                                    phi_584_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e374 = phi_584_;
                                if ((((((_e299.member[0] <= _e304.member_2[0]) && (_e304.member[0] <= _e299.member_2[0])) && (_e299.member[1] <= _e304.member_2[1])) && (_e304.member[1] <= _e299.member_2[1])) && (_e299.member[2] <= _e304.member_2[2])) && (_e304.member[2] <= _e299.member_2[2])) {
                                    phi_613_ = _e320;
                                } else {
                                    phi_613_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e399 = phi_613_;
                                if ((((((_e299.member[0] <= _e309.member_2[0]) && (_e309.member[0] <= _e299.member_2[0])) && (_e299.member[1] <= _e309.member_2[1])) && (_e309.member[1] <= _e299.member_2[1])) && (_e299.member[2] <= _e309.member_2[2])) && (_e309.member[2] <= _e299.member_2[2])) {
                                    phi_642_ = _e323;
                                } else {
                                    phi_642_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e424 = phi_642_;
                                phi_644_ = type_22(array<array<u32, 2>, 4>(_e314, _e317, _e320, _e323), array<array<u32, 2>, 4>(_e349, _e374, _e399, _e424));
                                phi_645_ = false;
                            } else {
                                phi_644_ = type_22();
                                phi_645_ = true;
                            }
                            let _e428 = phi_644_;
                            let _e430 = phi_645_;
                            phi_646_ = _e428;
                            phi_647_ = _e430;
                        } else {
                            phi_646_ = type_22();
                            phi_647_ = true;
                        }
                        let _e432 = phi_646_;
                        let _e434 = phi_647_;
                        if _e434 {
                            if _e291 {
                                let _e519 = a_nodes.member[_e134.member_1];
                                let _e524 = a_nodes.member[_e134.member_3];
                                if ((((((_e519.member[0] <= _e136.member_2[0]) && (_e136.member[0] <= _e519.member_2[0])) && (_e519.member[1] <= _e136.member_2[1])) && (_e136.member[1] <= _e519.member_2[1])) && (_e519.member[2] <= _e136.member_2[2])) && (_e136.member[2] <= _e519.member_2[2])) {
                                    phi_720_ = array<u32, 2>(_e134.member_1, _e122);
                                } else {
                                    phi_720_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e557 = phi_720_;
                                let _e564 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e557, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e524.member[0] <= _e136.member_2[0]) && (_e136.member[0] <= _e524.member_2[0])) && (_e524.member[1] <= _e136.member_2[1])) && (_e136.member[1] <= _e524.member_2[1])) && (_e524.member[2] <= _e136.member_2[2])) && (_e136.member[2] <= _e524.member_2[2])) {
                                    phi_752_ = array<u32, 2>(_e134.member_3, _e122);
                                } else {
                                    phi_752_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e591 = phi_752_;
                                phi_854_ = type_22(_e564.member, array<array<u32, 2>, 4>(_e564.member_1[0], _e591, _e564.member_1[2], _e564.member_1[3]));
                            } else {
                                let _e437 = b_nodes.member[_e136.member_1];
                                let _e442 = b_nodes.member[_e136.member_3];
                                if ((((((_e134.member[0] <= _e437.member_2[0]) && (_e437.member[0] <= _e134.member_2[0])) && (_e134.member[1] <= _e437.member_2[1])) && (_e437.member[1] <= _e134.member_2[1])) && (_e134.member[2] <= _e437.member_2[2])) && (_e437.member[2] <= _e134.member_2[2])) {
                                    phi_820_ = array<u32, 2>(_e119, _e136.member_1);
                                } else {
                                    phi_820_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e475 = phi_820_;
                                let _e482 = type_22(type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e475, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e134.member[0] <= _e442.member_2[0]) && (_e442.member[0] <= _e134.member_2[0])) && (_e134.member[1] <= _e442.member_2[1])) && (_e442.member[1] <= _e134.member_2[1])) && (_e134.member[2] <= _e442.member_2[2])) && (_e442.member[2] <= _e134.member_2[2])) {
                                    phi_852_ = array<u32, 2>(_e119, _e136.member_3);
                                } else {
                                    phi_852_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e509 = phi_852_;
                                phi_854_ = type_22(_e482.member, array<array<u32, 2>, 4>(_e482.member_1[0], _e509, _e482.member_1[2], _e482.member_1[3]));
                            }
                            let _e600 = phi_854_;
                            phi_855_ = _e600;
                        } else {
                            phi_855_ = _e432;
                        }
                        let _e602 = phi_855_;
                        phi_856_ = _e602;
                        phi_857_ = false;
                    } else {
                        phi_856_ = type_22();
                        phi_857_ = true;
                    }
                    let _e604 = phi_856_;
                    let _e606 = phi_857_;
                    phi_858_ = _e604;
                    phi_859_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_860_ = _e606;
                } else {
                    phi_858_ = type_22();
                    phi_859_ = _e240;
                    phi_860_ = true;
                }
                let _e608 = phi_858_;
                let _e610 = phi_859_;
                let _e612 = phi_860_;
                if _e612 {
                    phi_864_ = _e610;
                } else {
                    phi_864_ = _e608;
                }
                let _e614 = phi_864_;
                if (_e119 == 4294967295u) {
                    phi_888_ = 0u;
                } else {
                    if (_e119 >= _e61) {
                        if (_e122 >= _e66) {
                            phi_882_ = false;
                        } else {
                            phi_882_ = true;
                        }
                        let _e624 = phi_882_;
                        phi_883_ = _e624;
                    } else {
                        phi_883_ = true;
                    }
                    let _e626 = phi_883_;
                    if _e626 {
                        phi_887_ = 1u;
                    } else {
                        phi_887_ = 2u;
                    }
                    let _e628 = phi_887_;
                    phi_888_ = _e628;
                }
                let _e630 = phi_888_;
                if (_e630 == 2u) {
                    phi_894_ = array<u32, 2>(_e119, _e122);
                } else {
                    phi_894_ = _e614.member_1[0];
                }
                let _e634 = phi_894_;
                phi_895_ = _e614.member_1[3];
                phi_896_ = _e614.member_1[2];
                phi_897_ = _e614.member_1[1];
                phi_898_ = _e634;
            } else {
                phi_895_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_896_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_897_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_898_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e636 = phi_895_;
            let _e638 = phi_896_;
            let _e640 = phi_897_;
            let _e642 = phi_898_;
            if (_e642[0] == 4294967295u) {
                phi_920_ = 0u;
            } else {
                if (_e642[0] >= _e61) {
                    if (_e642[1] >= _e66) {
                        phi_914_ = false;
                    } else {
                        phi_914_ = true;
                    }
                    let _e650 = phi_914_;
                    phi_915_ = _e650;
                } else {
                    phi_915_ = true;
                }
                let _e652 = phi_915_;
                if _e652 {
                    phi_919_ = 1u;
                } else {
                    phi_919_ = 2u;
                }
                let _e654 = phi_919_;
                phi_920_ = _e654;
            }
            let _e656 = phi_920_;
            if (_e656 == 0u) {
                phi_932_ = 0u;
            } else {
                if (_e656 == 1u) {
                    phi_929_ = 0u;
                } else {
                    phi_929_ = 1u;
                }
                let _e660 = phi_929_;
                let _e662 = atomicAdd((&counters[_e660]), 1u);
                phi_932_ = _e662;
            }
            let _e664 = phi_932_;
            if (_e640[0] == 4294967295u) {
                phi_954_ = 0u;
            } else {
                if (_e640[0] >= _e61) {
                    if (_e640[1] >= _e66) {
                        phi_948_ = false;
                    } else {
                        phi_948_ = true;
                    }
                    let _e672 = phi_948_;
                    phi_949_ = _e672;
                } else {
                    phi_949_ = true;
                }
                let _e674 = phi_949_;
                if _e674 {
                    phi_953_ = 1u;
                } else {
                    phi_953_ = 2u;
                }
                let _e676 = phi_953_;
                phi_954_ = _e676;
            }
            let _e678 = phi_954_;
            if (_e678 == 0u) {
                phi_966_ = 0u;
            } else {
                if (_e678 == 1u) {
                    phi_963_ = 0u;
                } else {
                    phi_963_ = 1u;
                }
                let _e682 = phi_963_;
                let _e684 = atomicAdd((&counters[_e682]), 1u);
                phi_966_ = _e684;
            }
            let _e686 = phi_966_;
            if (_e638[0] == 4294967295u) {
                phi_988_ = 0u;
            } else {
                if (_e638[0] >= _e61) {
                    if (_e638[1] >= _e66) {
                        phi_982_ = false;
                    } else {
                        phi_982_ = true;
                    }
                    let _e694 = phi_982_;
                    phi_983_ = _e694;
                } else {
                    phi_983_ = true;
                }
                let _e696 = phi_983_;
                if _e696 {
                    phi_987_ = 1u;
                } else {
                    phi_987_ = 2u;
                }
                let _e698 = phi_987_;
                phi_988_ = _e698;
            }
            let _e700 = phi_988_;
            if (_e700 == 0u) {
                phi_1000_ = 0u;
            } else {
                if (_e700 == 1u) {
                    phi_997_ = 0u;
                } else {
                    phi_997_ = 1u;
                }
                let _e704 = phi_997_;
                let _e706 = atomicAdd((&counters[_e704]), 1u);
                phi_1000_ = _e706;
            }
            let _e708 = phi_1000_;
            if (_e636[0] == 4294967295u) {
                phi_1022_ = 0u;
            } else {
                if (_e636[0] >= _e61) {
                    if (_e636[1] >= _e66) {
                        phi_1016_ = false;
                    } else {
                        phi_1016_ = true;
                    }
                    let _e716 = phi_1016_;
                    phi_1017_ = _e716;
                } else {
                    phi_1017_ = true;
                }
                let _e718 = phi_1017_;
                if _e718 {
                    phi_1021_ = 1u;
                } else {
                    phi_1021_ = 2u;
                }
                let _e720 = phi_1021_;
                phi_1022_ = _e720;
            }
            let _e722 = phi_1022_;
            if (_e722 == 0u) {
                phi_1034_ = 0u;
            } else {
                if (_e722 == 1u) {
                    phi_1031_ = 0u;
                } else {
                    phi_1031_ = 1u;
                }
                let _e726 = phi_1031_;
                let _e728 = atomicAdd((&counters[_e726]), 1u);
                phi_1034_ = _e728;
            }
            let _e730 = phi_1034_;
            workgroupBarrier();
            if (_e30 == 0u) {
                let _e733 = atomicLoad((&counters[0u]));
                let _e735 = atomicLoad((&counters[1u]));
                if (_e733 > 0u) {
                    let _e739 = atomicAdd((&levels.member[(_e48 + 1u)]), _e733);
                    let _e742 = atomicMax((&output.member[0u]), (_e739 + _e733));
                    if ((_e739 + _e733) < _e739) {
                        let _e746 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e739);
                }
                if (_e735 > 0u) {
                    let _e750 = atomicAdd((&pairs.member[0u]), _e735);
                    if ((_e750 + _e735) < _e750) {
                        let _e754 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e750);
                }
            }
            workgroupBarrier();
            let _e757 = atomicLoad((&counters[2u]));
            let _e759 = atomicLoad((&counters[3u]));
            if (_e642[0] == 4294967295u) {
                phi_1106_ = 0u;
            } else {
                if (_e642[0] >= _e61) {
                    if (_e642[1] >= _e66) {
                        phi_1100_ = false;
                    } else {
                        phi_1100_ = true;
                    }
                    let _e767 = phi_1100_;
                    phi_1101_ = _e767;
                } else {
                    phi_1101_ = true;
                }
                let _e769 = phi_1101_;
                if _e769 {
                    phi_1105_ = 1u;
                } else {
                    phi_1105_ = 2u;
                }
                let _e771 = phi_1105_;
                phi_1106_ = _e771;
            }
            let _e773 = phi_1106_;
            if (_e773 == 1u) {
                let _e812 = params.member.member_2.member_3;
                let _e813 = (_e757 + _e664);
                if (_e813 < _e812) {
                    let _e815 = (2u * _e813);
                    atomicStore((&output.member[(4u + _e815)]), _e642[0]);
                    atomicStore((&output.member[(_e815 + 5u)]), _e642[1]);
                }
            } else {
                if (_e773 == 2u) {
                    let _e778 = params.member.member_1.member_3;
                    let _e779 = (_e759 + _e664);
                    let _e782 = a_nodes.member[_e642[0]];
                    let _e786 = b_nodes.member[_e642[1]];
                    let _e790 = params.member.member_2.member;
                    if (_e790 == 1u) {
                        if (_e782.member_1 < _e786.member_1) {
                            phi_1180_ = type_9(_e782.member_1, _e786.member_1);
                        } else {
                            phi_1180_ = type_9(_e786.member_1, _e782.member_1);
                        }
                        let _e797 = phi_1180_;
                        phi_1185_ = _e797;
                    } else {
                        phi_1185_ = type_9(_e782.member_1, _e786.member_1);
                    }
                    let _e799 = phi_1185_;
                    if (_e779 < _e778) {
                        let _e803 = (2u * _e779);
                        atomicStore((&pairs.member[(4u + _e803)]), _e799.member);
                        atomicStore((&pairs.member[(_e803 + 5u)]), _e799.member_1);
                    }
                }
            }
            if (_e640[0] == 4294967295u) {
                phi_1220_ = 0u;
            } else {
                if (_e640[0] >= _e61) {
                    if (_e640[1] >= _e66) {
                        phi_1214_ = false;
                    } else {
                        phi_1214_ = true;
                    }
                    let _e827 = phi_1214_;
                    phi_1215_ = _e827;
                } else {
                    phi_1215_ = true;
                }
                let _e829 = phi_1215_;
                if _e829 {
                    phi_1219_ = 1u;
                } else {
                    phi_1219_ = 2u;
                }
                let _e831 = phi_1219_;
                phi_1220_ = _e831;
            }
            let _e833 = phi_1220_;
            if (_e833 == 1u) {
                let _e872 = params.member.member_2.member_3;
                let _e873 = (_e757 + _e686);
                if (_e873 < _e872) {
                    let _e875 = (2u * _e873);
                    atomicStore((&output.member[(4u + _e875)]), _e640[0]);
                    atomicStore((&output.member[(_e875 + 5u)]), _e640[1]);
                }
            } else {
                if (_e833 == 2u) {
                    let _e838 = params.member.member_1.member_3;
                    let _e839 = (_e759 + _e686);
                    let _e842 = a_nodes.member[_e640[0]];
                    let _e846 = b_nodes.member[_e640[1]];
                    let _e850 = params.member.member_2.member;
                    if (_e850 == 1u) {
                        if (_e842.member_1 < _e846.member_1) {
                            phi_1294_ = type_9(_e842.member_1, _e846.member_1);
                        } else {
                            phi_1294_ = type_9(_e846.member_1, _e842.member_1);
                        }
                        let _e857 = phi_1294_;
                        phi_1299_ = _e857;
                    } else {
                        phi_1299_ = type_9(_e842.member_1, _e846.member_1);
                    }
                    let _e859 = phi_1299_;
                    if (_e839 < _e838) {
                        let _e863 = (2u * _e839);
                        atomicStore((&pairs.member[(4u + _e863)]), _e859.member);
                        atomicStore((&pairs.member[(_e863 + 5u)]), _e859.member_1);
                    }
                }
            }
            if (_e638[0] == 4294967295u) {
                phi_1334_ = 0u;
            } else {
                if (_e638[0] >= _e61) {
                    if (_e638[1] >= _e66) {
                        phi_1328_ = false;
                    } else {
                        phi_1328_ = true;
                    }
                    let _e887 = phi_1328_;
                    phi_1329_ = _e887;
                } else {
                    phi_1329_ = true;
                }
                let _e889 = phi_1329_;
                if _e889 {
                    phi_1333_ = 1u;
                } else {
                    phi_1333_ = 2u;
                }
                let _e891 = phi_1333_;
                phi_1334_ = _e891;
            }
            let _e893 = phi_1334_;
            if (_e893 == 1u) {
                let _e932 = params.member.member_2.member_3;
                let _e933 = (_e757 + _e708);
                if (_e933 < _e932) {
                    let _e935 = (2u * _e933);
                    atomicStore((&output.member[(4u + _e935)]), _e638[0]);
                    atomicStore((&output.member[(_e935 + 5u)]), _e638[1]);
                }
            } else {
                if (_e893 == 2u) {
                    let _e898 = params.member.member_1.member_3;
                    let _e899 = (_e759 + _e708);
                    let _e902 = a_nodes.member[_e638[0]];
                    let _e906 = b_nodes.member[_e638[1]];
                    let _e910 = params.member.member_2.member;
                    if (_e910 == 1u) {
                        if (_e902.member_1 < _e906.member_1) {
                            phi_1408_ = type_9(_e902.member_1, _e906.member_1);
                        } else {
                            phi_1408_ = type_9(_e906.member_1, _e902.member_1);
                        }
                        let _e917 = phi_1408_;
                        phi_1413_ = _e917;
                    } else {
                        phi_1413_ = type_9(_e902.member_1, _e906.member_1);
                    }
                    let _e919 = phi_1413_;
                    if (_e899 < _e898) {
                        let _e923 = (2u * _e899);
                        atomicStore((&pairs.member[(4u + _e923)]), _e919.member);
                        atomicStore((&pairs.member[(_e923 + 5u)]), _e919.member_1);
                    }
                }
            }
            if (_e636[0] == 4294967295u) {
                phi_1448_ = 0u;
            } else {
                if (_e636[0] >= _e61) {
                    if (_e636[1] >= _e66) {
                        phi_1442_ = false;
                    } else {
                        phi_1442_ = true;
                    }
                    let _e947 = phi_1442_;
                    phi_1443_ = _e947;
                } else {
                    phi_1443_ = true;
                }
                let _e949 = phi_1443_;
                if _e949 {
                    phi_1447_ = 1u;
                } else {
                    phi_1447_ = 2u;
                }
                let _e951 = phi_1447_;
                phi_1448_ = _e951;
            }
            let _e953 = phi_1448_;
            if (_e953 == 1u) {
                let _e992 = params.member.member_2.member_3;
                let _e993 = (_e757 + _e730);
                if (_e993 < _e992) {
                    let _e995 = (2u * _e993);
                    atomicStore((&output.member[(4u + _e995)]), _e636[0]);
                    atomicStore((&output.member[(_e995 + 5u)]), _e636[1]);
                }
            } else {
                if (_e953 == 2u) {
                    let _e958 = params.member.member_1.member_3;
                    let _e959 = (_e759 + _e730);
                    let _e962 = a_nodes.member[_e636[0]];
                    let _e966 = b_nodes.member[_e636[1]];
                    let _e970 = params.member.member_2.member;
                    if (_e970 == 1u) {
                        if (_e962.member_1 < _e966.member_1) {
                            phi_1522_ = type_9(_e962.member_1, _e966.member_1);
                        } else {
                            phi_1522_ = type_9(_e966.member_1, _e962.member_1);
                        }
                        let _e977 = phi_1522_;
                        phi_1527_ = _e977;
                    } else {
                        phi_1527_ = type_9(_e962.member_1, _e966.member_1);
                    }
                    let _e979 = phi_1527_;
                    if (_e959 < _e958) {
                        let _e983 = (2u * _e959);
                        atomicStore((&pairs.member[(4u + _e983)]), _e979.member);
                        atomicStore((&pairs.member[(_e983 + 5u)]), _e979.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_178_ = _e101;
            break if !(_e107);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
