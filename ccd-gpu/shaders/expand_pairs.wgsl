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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> input: type_10;
@group(0) @binding(4) 
var<storage, read_write> levels: type_25;
@group(0) @binding(5) 
var<storage, read_write> output: type_25;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_25;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_106_: array<u32, 2>;
    var phi_132_: u32;
    var phi_150_: u32;
    var phi_170_: u32;
    var phi_173_: type_12;
    var phi_174_: type_12;
    var phi_197_: type_12;
    var phi_305_: array<u32, 2>;
    var phi_319_: array<u32, 2>;
    var phi_356_: array<u32, 2>;
    var phi_358_: type_22;
    var phi_359_: type_22;
    var phi_360_: bool;
    var phi_361_: type_22;
    var phi_362_: bool;
    var phi_378_: bool;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_533_: array<u32, 2>;
    var phi_562_: array<u32, 2>;
    var phi_591_: array<u32, 2>;
    var phi_620_: array<u32, 2>;
    var phi_622_: type_22;
    var phi_623_: bool;
    var phi_624_: type_22;
    var phi_625_: bool;
    var phi_798_: array<u32, 2>;
    var phi_830_: array<u32, 2>;
    var phi_698_: array<u32, 2>;
    var phi_730_: array<u32, 2>;
    var phi_832_: type_22;
    var phi_833_: type_22;
    var phi_834_: type_22;
    var phi_835_: bool;
    var phi_836_: type_22;
    var phi_837_: type_22;
    var phi_838_: bool;
    var phi_842_: type_22;
    var phi_860_: bool;
    var phi_861_: bool;
    var phi_865_: u32;
    var phi_866_: u32;
    var phi_872_: array<u32, 2>;
    var phi_873_: array<u32, 2>;
    var phi_874_: array<u32, 2>;
    var phi_875_: array<u32, 2>;
    var phi_876_: array<u32, 2>;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_897_: u32;
    var phi_898_: u32;
    var phi_907_: u32;
    var phi_910_: u32;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_931_: u32;
    var phi_932_: u32;
    var phi_941_: u32;
    var phi_944_: u32;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_965_: u32;
    var phi_966_: u32;
    var phi_975_: u32;
    var phi_978_: u32;
    var phi_994_: bool;
    var phi_995_: bool;
    var phi_999_: u32;
    var phi_1000_: u32;
    var phi_1009_: u32;
    var phi_1012_: u32;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1083_: u32;
    var phi_1084_: u32;
    var phi_1147_: type_12;
    var phi_1152_: type_12;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1190_: u32;
    var phi_1191_: u32;
    var phi_1254_: type_12;
    var phi_1259_: type_12;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1297_: u32;
    var phi_1298_: u32;
    var phi_1361_: type_12;
    var phi_1366_: type_12;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1404_: u32;
    var phi_1405_: u32;
    var phi_1468_: type_12;
    var phi_1473_: type_12;
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
    if (_e48 == 0u) {
        phi_106_ = array<u32, 2>(0u, 2u);
    } else {
        phi_106_ = array<u32, 2>(1u, 1u);
    }
    let _e54 = phi_106_;
    let _e60 = params.member.member.member[_e54[0]];
    let _e61 = (_e60 - 1u);
    let _e65 = params.member.member.member[_e54[1]];
    let _e66 = (_e65 - 1u);
    let _e69 = params.member.member_2.member_1;
    if (_e69 == 0u) {
        phi_132_ = 1u;
    } else {
        phi_132_ = 0u;
    }
    let _e72 = phi_132_;
    let _e74 = atomicLoad((&levels.member[_e51]));
    let _e77 = params.member.member_1.member_2;
    if (_e77 < _e74) {
        phi_150_ = _e77;
    } else {
        phi_150_ = _e74;
    }
    let _e80 = phi_150_;
    let _e83 = params.member.member_1.member_2;
    let _e84 = (_e45 * 128u);
    if (_e84 == 0u) {
        return;
    }
    let _e86 = (_e83 / _e84);
    if (_e84 == 0u) {
        return;
    }
    if ((_e83 % _e84) > 0u) {
        phi_170_ = (_e86 + 1u);
    } else {
        phi_170_ = _e86;
    }
    let _e92 = phi_170_;
    phi_173_ = type_12(0u, _e92);
    loop {
        let _e95 = phi_173_;
        if (_e95.member < _e95.member_1) {
            phi_174_ = type_12((_e95.member + 1u), _e95.member_1);
            phi_197_ = type_12(1u, _e95.member);
        } else {
            phi_174_ = _e95;
            phi_197_ = type_12(0u, type_12().member_1);
        }
        let _e107 = phi_174_;
        let _e109 = phi_197_;
        let _e113 = (bitcast<i32>(_e109.member) != 0i);
        if _e113 {
            let _e117 = (((((_e28.y * _e29.x) + _e28.x) + (_e109.member_1 * _e45)) * 128u) + _e30);
            if (_e30 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e117 < _e80) {
                let _e122 = (2u * _e117);
                let _e125 = input.member[(4u + _e122)];
                let _e128 = input.member[(_e122 + 5u)];
                let _e131 = a_nodes.member[_e125];
                let _e133 = b_nodes.member[_e128];
                if (_e48 == 1u) {
                    if (_e125 == _e128) {
                        if (_e131.member_3 == 4294967295u) {
                            phi_358_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e139 = a_nodes.member[_e131.member_1];
                            let _e142 = a_nodes.member[_e131.member_3];
                            if !((_e139.member_3 == 4294967295u)) {
                                phi_305_ = array<u32, 2>(_e131.member_1, _e131.member_1);
                            } else {
                                phi_305_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e149 = phi_305_;
                            let _e156 = type_22(array<array<u32, 2>, 4>(_e149, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e168 = type_22(array<array<u32, 2>, 4>(_e156.member[0], array<u32, 2>(_e131.member_1, _e156.member[1][1]), _e156.member[2], _e156.member[3]), _e156.member_1);
                            let _e169 = array<u32, 2>(_e131.member_1, _e131.member_3);
                            let _e176 = type_22(array<array<u32, 2>, 4>(_e168.member[0], _e169, _e168.member[2], _e168.member[3]), _e168.member_1);
                            if !((_e142.member_3 == 4294967295u)) {
                                phi_319_ = array<u32, 2>(_e131.member_3, _e131.member_3);
                            } else {
                                phi_319_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e183 = phi_319_;
                            let _e190 = type_22(array<array<u32, 2>, 4>(_e176.member[0], _e176.member[1], _e183, _e176.member[3]), _e176.member_1);
                            let _e193 = type_22(_e190.member, _e190.member);
                            if ((((((_e139.member[0] <= _e142.member_2[0]) && (_e142.member[0] <= _e139.member_2[0])) && (_e139.member[1] <= _e142.member_2[1])) && (_e142.member[1] <= _e139.member_2[1])) && (_e139.member[2] <= _e142.member_2[2])) && (_e142.member[2] <= _e139.member_2[2])) {
                                phi_356_ = _e169;
                            } else {
                                phi_356_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e222 = phi_356_;
                            phi_358_ = type_22(_e193.member, array<array<u32, 2>, 4>(_e193.member_1[0], _e222, _e193.member_1[2], _e193.member_1[3]));
                        }
                        let _e231 = phi_358_;
                        phi_359_ = _e231;
                        phi_360_ = false;
                    } else {
                        phi_359_ = type_22();
                        phi_360_ = true;
                    }
                    let _e233 = phi_359_;
                    let _e235 = phi_360_;
                    phi_361_ = _e233;
                    phi_362_ = _e235;
                } else {
                    phi_361_ = type_22();
                    phi_362_ = true;
                }
                let _e237 = phi_361_;
                let _e239 = phi_362_;
                if _e239 {
                    let _e242 = !((_e131.member_3 == 4294967295u));
                    let _e245 = !((_e133.member_3 == 4294967295u));
                    if _e242 {
                        phi_378_ = true;
                    } else {
                        phi_378_ = _e245;
                    }
                    let _e247 = phi_378_;
                    if _e247 {
                        if _e242 {
                            if _e245 {
                                if (_e72 == 0u) {
                                    let _e275 = ((((_e133.member_2[0] - _e133.member[0]) * (_e133.member_2[1] - _e133.member[1])) * (_e133.member_2[2] - _e133.member[2])) > (((_e131.member_2[0] - _e131.member[0]) * (_e131.member_2[1] - _e131.member[1])) * (_e131.member_2[2] - _e131.member[2])));
                                    phi_422_ = _e275;
                                    phi_423_ = !(_e275);
                                } else {
                                    phi_422_ = _e245;
                                    phi_423_ = _e242;
                                }
                                let _e278 = phi_422_;
                                let _e280 = phi_423_;
                                phi_424_ = _e278;
                                phi_425_ = _e280;
                            } else {
                                phi_424_ = _e245;
                                phi_425_ = _e242;
                            }
                            let _e282 = phi_424_;
                            let _e284 = phi_425_;
                            phi_426_ = _e282;
                            phi_427_ = _e284;
                        } else {
                            phi_426_ = _e245;
                            phi_427_ = _e242;
                        }
                        let _e286 = phi_426_;
                        let _e288 = phi_427_;
                        if _e288 {
                            if _e286 {
                                let _e291 = a_nodes.member[_e131.member_1];
                                let _e296 = a_nodes.member[_e131.member_3];
                                let _e301 = b_nodes.member[_e133.member_1];
                                let _e306 = b_nodes.member[_e133.member_3];
                                let _e311 = array<u32, 2>(_e131.member_1, _e133.member_1);
                                let _e314 = array<u32, 2>(_e131.member_1, _e133.member_3);
                                let _e317 = array<u32, 2>(_e131.member_3, _e133.member_1);
                                let _e320 = array<u32, 2>(_e131.member_3, _e133.member_3);
                                if ((((((_e291.member[0] <= _e301.member_2[0]) && (_e301.member[0] <= _e291.member_2[0])) && (_e291.member[1] <= _e301.member_2[1])) && (_e301.member[1] <= _e291.member_2[1])) && (_e291.member[2] <= _e301.member_2[2])) && (_e301.member[2] <= _e291.member_2[2])) {
                                    phi_533_ = _e311;
                                } else {
                                    phi_533_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e346 = phi_533_;
                                if ((((((_e291.member[0] <= _e306.member_2[0]) && (_e306.member[0] <= _e291.member_2[0])) && (_e291.member[1] <= _e306.member_2[1])) && (_e306.member[1] <= _e291.member_2[1])) && (_e291.member[2] <= _e306.member_2[2])) && (_e306.member[2] <= _e291.member_2[2])) {
                                    phi_562_ = _e314;
                                } else {
                                    phi_562_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e371 = phi_562_;
                                if ((((((_e296.member[0] <= _e301.member_2[0]) && (_e301.member[0] <= _e296.member_2[0])) && (_e296.member[1] <= _e301.member_2[1])) && (_e301.member[1] <= _e296.member_2[1])) && (_e296.member[2] <= _e301.member_2[2])) && (_e301.member[2] <= _e296.member_2[2])) {
                                    phi_591_ = _e317;
                                } else {
                                    phi_591_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e396 = phi_591_;
                                if ((((((_e296.member[0] <= _e306.member_2[0]) && (_e306.member[0] <= _e296.member_2[0])) && (_e296.member[1] <= _e306.member_2[1])) && (_e306.member[1] <= _e296.member_2[1])) && (_e296.member[2] <= _e306.member_2[2])) && (_e306.member[2] <= _e296.member_2[2])) {
                                    phi_620_ = _e320;
                                } else {
                                    phi_620_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e421 = phi_620_;
                                phi_622_ = type_22(array<array<u32, 2>, 4>(_e311, _e314, _e317, _e320), array<array<u32, 2>, 4>(_e346, _e371, _e396, _e421));
                                phi_623_ = false;
                            } else {
                                phi_622_ = type_22();
                                phi_623_ = true;
                            }
                            let _e425 = phi_622_;
                            let _e427 = phi_623_;
                            phi_624_ = _e425;
                            phi_625_ = _e427;
                        } else {
                            phi_624_ = type_22();
                            phi_625_ = true;
                        }
                        let _e429 = phi_624_;
                        let _e431 = phi_625_;
                        if _e431 {
                            if _e288 {
                                let _e530 = a_nodes.member[_e131.member_1];
                                let _e535 = a_nodes.member[_e131.member_3];
                                let _e539 = array<u32, 2>(_e131.member_1, _e128);
                                let _e541 = array<u32, 2>(_e131.member_3, _e128);
                                let _e548 = type_22(array<array<u32, 2>, 4>(_e539, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e555 = type_22(array<array<u32, 2>, 4>(_e548.member[0], _e541, _e548.member[2], _e548.member[3]), _e548.member_1);
                                if ((((((_e530.member[0] <= _e133.member_2[0]) && (_e133.member[0] <= _e530.member_2[0])) && (_e530.member[1] <= _e133.member_2[1])) && (_e133.member[1] <= _e530.member_2[1])) && (_e530.member[2] <= _e133.member_2[2])) && (_e133.member[2] <= _e530.member_2[2])) {
                                    phi_698_ = _e539;
                                } else {
                                    phi_698_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e582 = phi_698_;
                                let _e589 = type_22(_e555.member, array<array<u32, 2>, 4>(_e582, _e555.member_1[1], _e555.member_1[2], _e555.member_1[3]));
                                if ((((((_e535.member[0] <= _e133.member_2[0]) && (_e133.member[0] <= _e535.member_2[0])) && (_e535.member[1] <= _e133.member_2[1])) && (_e133.member[1] <= _e535.member_2[1])) && (_e535.member[2] <= _e133.member_2[2])) && (_e133.member[2] <= _e535.member_2[2])) {
                                    phi_730_ = _e541;
                                } else {
                                    phi_730_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e616 = phi_730_;
                                phi_832_ = type_22(_e589.member, array<array<u32, 2>, 4>(_e589.member_1[0], _e616, _e589.member_1[2], _e589.member_1[3]));
                            } else {
                                let _e434 = b_nodes.member[_e133.member_1];
                                let _e439 = b_nodes.member[_e133.member_3];
                                let _e443 = array<u32, 2>(_e125, _e133.member_1);
                                let _e445 = array<u32, 2>(_e125, _e133.member_3);
                                let _e452 = type_22(array<array<u32, 2>, 4>(_e443, type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e459 = type_22(array<array<u32, 2>, 4>(_e452.member[0], _e445, _e452.member[2], _e452.member[3]), _e452.member_1);
                                if ((((((_e131.member[0] <= _e434.member_2[0]) && (_e434.member[0] <= _e131.member_2[0])) && (_e131.member[1] <= _e434.member_2[1])) && (_e434.member[1] <= _e131.member_2[1])) && (_e131.member[2] <= _e434.member_2[2])) && (_e434.member[2] <= _e131.member_2[2])) {
                                    phi_798_ = _e443;
                                } else {
                                    phi_798_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e486 = phi_798_;
                                let _e493 = type_22(_e459.member, array<array<u32, 2>, 4>(_e486, _e459.member_1[1], _e459.member_1[2], _e459.member_1[3]));
                                if ((((((_e131.member[0] <= _e439.member_2[0]) && (_e439.member[0] <= _e131.member_2[0])) && (_e131.member[1] <= _e439.member_2[1])) && (_e439.member[1] <= _e131.member_2[1])) && (_e131.member[2] <= _e439.member_2[2])) && (_e439.member[2] <= _e131.member_2[2])) {
                                    phi_830_ = _e445;
                                } else {
                                    phi_830_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e520 = phi_830_;
                                phi_832_ = type_22(_e493.member, array<array<u32, 2>, 4>(_e493.member_1[0], _e520, _e493.member_1[2], _e493.member_1[3]));
                            }
                            let _e625 = phi_832_;
                            phi_833_ = _e625;
                        } else {
                            phi_833_ = _e429;
                        }
                        let _e627 = phi_833_;
                        phi_834_ = _e627;
                        phi_835_ = false;
                    } else {
                        phi_834_ = type_22();
                        phi_835_ = true;
                    }
                    let _e629 = phi_834_;
                    let _e631 = phi_835_;
                    phi_836_ = _e629;
                    phi_837_ = type_22(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_838_ = _e631;
                } else {
                    phi_836_ = type_22();
                    phi_837_ = _e237;
                    phi_838_ = true;
                }
                let _e633 = phi_836_;
                let _e635 = phi_837_;
                let _e637 = phi_838_;
                if _e637 {
                    phi_842_ = _e635;
                } else {
                    phi_842_ = _e633;
                }
                let _e639 = phi_842_;
                if (_e125 == 4294967295u) {
                    phi_866_ = 0u;
                } else {
                    if (_e125 >= _e61) {
                        if (_e128 >= _e66) {
                            phi_860_ = false;
                        } else {
                            phi_860_ = true;
                        }
                        let _e649 = phi_860_;
                        phi_861_ = _e649;
                    } else {
                        phi_861_ = true;
                    }
                    let _e651 = phi_861_;
                    if _e651 {
                        phi_865_ = 1u;
                    } else {
                        phi_865_ = 2u;
                    }
                    let _e653 = phi_865_;
                    phi_866_ = _e653;
                }
                let _e655 = phi_866_;
                if (_e655 == 2u) {
                    phi_872_ = array<u32, 2>(_e125, _e128);
                } else {
                    phi_872_ = _e639.member_1[0];
                }
                let _e659 = phi_872_;
                phi_873_ = _e639.member_1[3];
                phi_874_ = _e639.member_1[2];
                phi_875_ = _e639.member_1[1];
                phi_876_ = _e659;
            } else {
                phi_873_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_874_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_875_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_876_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e661 = phi_873_;
            let _e663 = phi_874_;
            let _e665 = phi_875_;
            let _e667 = phi_876_;
            if (_e667[0] == 4294967295u) {
                phi_898_ = 0u;
            } else {
                if (_e667[0] >= _e61) {
                    if (_e667[1] >= _e66) {
                        phi_892_ = false;
                    } else {
                        phi_892_ = true;
                    }
                    let _e675 = phi_892_;
                    phi_893_ = _e675;
                } else {
                    phi_893_ = true;
                }
                let _e677 = phi_893_;
                if _e677 {
                    phi_897_ = 1u;
                } else {
                    phi_897_ = 2u;
                }
                let _e679 = phi_897_;
                phi_898_ = _e679;
            }
            let _e681 = phi_898_;
            if (_e681 == 0u) {
                phi_910_ = 0u;
            } else {
                if (_e681 == 1u) {
                    phi_907_ = 0u;
                } else {
                    phi_907_ = 1u;
                }
                let _e685 = phi_907_;
                let _e687 = atomicAdd((&counters[_e685]), 1u);
                phi_910_ = _e687;
            }
            let _e689 = phi_910_;
            if (_e665[0] == 4294967295u) {
                phi_932_ = 0u;
            } else {
                if (_e665[0] >= _e61) {
                    if (_e665[1] >= _e66) {
                        phi_926_ = false;
                    } else {
                        phi_926_ = true;
                    }
                    let _e697 = phi_926_;
                    phi_927_ = _e697;
                } else {
                    phi_927_ = true;
                }
                let _e699 = phi_927_;
                if _e699 {
                    phi_931_ = 1u;
                } else {
                    phi_931_ = 2u;
                }
                let _e701 = phi_931_;
                phi_932_ = _e701;
            }
            let _e703 = phi_932_;
            if (_e703 == 0u) {
                phi_944_ = 0u;
            } else {
                if (_e703 == 1u) {
                    phi_941_ = 0u;
                } else {
                    phi_941_ = 1u;
                }
                let _e707 = phi_941_;
                let _e709 = atomicAdd((&counters[_e707]), 1u);
                phi_944_ = _e709;
            }
            let _e711 = phi_944_;
            if (_e663[0] == 4294967295u) {
                phi_966_ = 0u;
            } else {
                if (_e663[0] >= _e61) {
                    if (_e663[1] >= _e66) {
                        phi_960_ = false;
                    } else {
                        phi_960_ = true;
                    }
                    let _e719 = phi_960_;
                    phi_961_ = _e719;
                } else {
                    phi_961_ = true;
                }
                let _e721 = phi_961_;
                if _e721 {
                    phi_965_ = 1u;
                } else {
                    phi_965_ = 2u;
                }
                let _e723 = phi_965_;
                phi_966_ = _e723;
            }
            let _e725 = phi_966_;
            if (_e725 == 0u) {
                phi_978_ = 0u;
            } else {
                if (_e725 == 1u) {
                    phi_975_ = 0u;
                } else {
                    phi_975_ = 1u;
                }
                let _e729 = phi_975_;
                let _e731 = atomicAdd((&counters[_e729]), 1u);
                phi_978_ = _e731;
            }
            let _e733 = phi_978_;
            if (_e661[0] == 4294967295u) {
                phi_1000_ = 0u;
            } else {
                if (_e661[0] >= _e61) {
                    if (_e661[1] >= _e66) {
                        phi_994_ = false;
                    } else {
                        phi_994_ = true;
                    }
                    let _e741 = phi_994_;
                    phi_995_ = _e741;
                } else {
                    phi_995_ = true;
                }
                let _e743 = phi_995_;
                if _e743 {
                    phi_999_ = 1u;
                } else {
                    phi_999_ = 2u;
                }
                let _e745 = phi_999_;
                phi_1000_ = _e745;
            }
            let _e747 = phi_1000_;
            if (_e747 == 0u) {
                phi_1012_ = 0u;
            } else {
                if (_e747 == 1u) {
                    phi_1009_ = 0u;
                } else {
                    phi_1009_ = 1u;
                }
                let _e751 = phi_1009_;
                let _e753 = atomicAdd((&counters[_e751]), 1u);
                phi_1012_ = _e753;
            }
            let _e755 = phi_1012_;
            workgroupBarrier();
            if (_e30 == 0u) {
                let _e758 = atomicLoad((&counters[0u]));
                let _e760 = atomicLoad((&counters[1u]));
                if (_e758 > 0u) {
                    let _e764 = atomicAdd((&levels.member[(_e51 + 1u)]), _e758);
                    let _e767 = atomicMax((&output.member[0u]), (_e764 + _e758));
                    if ((_e764 + _e758) < _e764) {
                        let _e771 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e764);
                }
                if (_e760 > 0u) {
                    let _e775 = atomicAdd((&pairs.member[0u]), _e760);
                    if ((_e775 + _e760) < _e775) {
                        let _e779 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e775);
                }
            }
            workgroupBarrier();
            let _e782 = atomicLoad((&counters[2u]));
            let _e784 = atomicLoad((&counters[3u]));
            if (_e667[0] == 4294967295u) {
                phi_1084_ = 0u;
            } else {
                if (_e667[0] >= _e61) {
                    if (_e667[1] >= _e66) {
                        phi_1078_ = false;
                    } else {
                        phi_1078_ = true;
                    }
                    let _e792 = phi_1078_;
                    phi_1079_ = _e792;
                } else {
                    phi_1079_ = true;
                }
                let _e794 = phi_1079_;
                if _e794 {
                    phi_1083_ = 1u;
                } else {
                    phi_1083_ = 2u;
                }
                let _e796 = phi_1083_;
                phi_1084_ = _e796;
            }
            let _e798 = phi_1084_;
            if (_e798 == 1u) {
                let _e837 = params.member.member_2.member_3;
                let _e838 = (_e782 + _e689);
                if (_e838 < _e837) {
                    let _e840 = (2u * _e838);
                    atomicStore((&output.member[(4u + _e840)]), _e667[0]);
                    atomicStore((&output.member[(_e840 + 5u)]), _e667[1]);
                }
            } else {
                if (_e798 == 2u) {
                    let _e803 = a_nodes.member[_e667[0]];
                    let _e807 = b_nodes.member[_e667[1]];
                    let _e811 = params.member.member_2.member;
                    if (_e811 == 1u) {
                        if (_e803.member_1 < _e807.member_1) {
                            phi_1147_ = type_12(_e803.member_1, _e807.member_1);
                        } else {
                            phi_1147_ = type_12(_e807.member_1, _e803.member_1);
                        }
                        let _e818 = phi_1147_;
                        phi_1152_ = _e818;
                    } else {
                        phi_1152_ = type_12(_e803.member_1, _e807.member_1);
                    }
                    let _e820 = phi_1152_;
                    let _e823 = params.member.member_1.member_3;
                    let _e824 = (_e784 + _e689);
                    if (_e824 < _e823) {
                        let _e828 = (2u * _e824);
                        atomicStore((&pairs.member[(4u + _e828)]), _e820.member);
                        atomicStore((&pairs.member[(_e828 + 5u)]), _e820.member_1);
                    }
                }
            }
            if (_e665[0] == 4294967295u) {
                phi_1191_ = 0u;
            } else {
                if (_e665[0] >= _e61) {
                    if (_e665[1] >= _e66) {
                        phi_1185_ = false;
                    } else {
                        phi_1185_ = true;
                    }
                    let _e852 = phi_1185_;
                    phi_1186_ = _e852;
                } else {
                    phi_1186_ = true;
                }
                let _e854 = phi_1186_;
                if _e854 {
                    phi_1190_ = 1u;
                } else {
                    phi_1190_ = 2u;
                }
                let _e856 = phi_1190_;
                phi_1191_ = _e856;
            }
            let _e858 = phi_1191_;
            if (_e858 == 1u) {
                let _e897 = params.member.member_2.member_3;
                let _e898 = (_e782 + _e711);
                if (_e898 < _e897) {
                    let _e900 = (2u * _e898);
                    atomicStore((&output.member[(4u + _e900)]), _e665[0]);
                    atomicStore((&output.member[(_e900 + 5u)]), _e665[1]);
                }
            } else {
                if (_e858 == 2u) {
                    let _e863 = a_nodes.member[_e665[0]];
                    let _e867 = b_nodes.member[_e665[1]];
                    let _e871 = params.member.member_2.member;
                    if (_e871 == 1u) {
                        if (_e863.member_1 < _e867.member_1) {
                            phi_1254_ = type_12(_e863.member_1, _e867.member_1);
                        } else {
                            phi_1254_ = type_12(_e867.member_1, _e863.member_1);
                        }
                        let _e878 = phi_1254_;
                        phi_1259_ = _e878;
                    } else {
                        phi_1259_ = type_12(_e863.member_1, _e867.member_1);
                    }
                    let _e880 = phi_1259_;
                    let _e883 = params.member.member_1.member_3;
                    let _e884 = (_e784 + _e711);
                    if (_e884 < _e883) {
                        let _e888 = (2u * _e884);
                        atomicStore((&pairs.member[(4u + _e888)]), _e880.member);
                        atomicStore((&pairs.member[(_e888 + 5u)]), _e880.member_1);
                    }
                }
            }
            if (_e663[0] == 4294967295u) {
                phi_1298_ = 0u;
            } else {
                if (_e663[0] >= _e61) {
                    if (_e663[1] >= _e66) {
                        phi_1292_ = false;
                    } else {
                        phi_1292_ = true;
                    }
                    let _e912 = phi_1292_;
                    phi_1293_ = _e912;
                } else {
                    phi_1293_ = true;
                }
                let _e914 = phi_1293_;
                if _e914 {
                    phi_1297_ = 1u;
                } else {
                    phi_1297_ = 2u;
                }
                let _e916 = phi_1297_;
                phi_1298_ = _e916;
            }
            let _e918 = phi_1298_;
            if (_e918 == 1u) {
                let _e957 = params.member.member_2.member_3;
                let _e958 = (_e782 + _e733);
                if (_e958 < _e957) {
                    let _e960 = (2u * _e958);
                    atomicStore((&output.member[(4u + _e960)]), _e663[0]);
                    atomicStore((&output.member[(_e960 + 5u)]), _e663[1]);
                }
            } else {
                if (_e918 == 2u) {
                    let _e923 = a_nodes.member[_e663[0]];
                    let _e927 = b_nodes.member[_e663[1]];
                    let _e931 = params.member.member_2.member;
                    if (_e931 == 1u) {
                        if (_e923.member_1 < _e927.member_1) {
                            phi_1361_ = type_12(_e923.member_1, _e927.member_1);
                        } else {
                            phi_1361_ = type_12(_e927.member_1, _e923.member_1);
                        }
                        let _e938 = phi_1361_;
                        phi_1366_ = _e938;
                    } else {
                        phi_1366_ = type_12(_e923.member_1, _e927.member_1);
                    }
                    let _e940 = phi_1366_;
                    let _e943 = params.member.member_1.member_3;
                    let _e944 = (_e784 + _e733);
                    if (_e944 < _e943) {
                        let _e948 = (2u * _e944);
                        atomicStore((&pairs.member[(4u + _e948)]), _e940.member);
                        atomicStore((&pairs.member[(_e948 + 5u)]), _e940.member_1);
                    }
                }
            }
            if (_e661[0] == 4294967295u) {
                phi_1405_ = 0u;
            } else {
                if (_e661[0] >= _e61) {
                    if (_e661[1] >= _e66) {
                        phi_1399_ = false;
                    } else {
                        phi_1399_ = true;
                    }
                    let _e972 = phi_1399_;
                    phi_1400_ = _e972;
                } else {
                    phi_1400_ = true;
                }
                let _e974 = phi_1400_;
                if _e974 {
                    phi_1404_ = 1u;
                } else {
                    phi_1404_ = 2u;
                }
                let _e976 = phi_1404_;
                phi_1405_ = _e976;
            }
            let _e978 = phi_1405_;
            if (_e978 == 1u) {
                let _e1017 = params.member.member_2.member_3;
                let _e1018 = (_e782 + _e755);
                if (_e1018 < _e1017) {
                    let _e1020 = (2u * _e1018);
                    atomicStore((&output.member[(4u + _e1020)]), _e661[0]);
                    atomicStore((&output.member[(_e1020 + 5u)]), _e661[1]);
                }
            } else {
                if (_e978 == 2u) {
                    let _e983 = a_nodes.member[_e661[0]];
                    let _e987 = b_nodes.member[_e661[1]];
                    let _e991 = params.member.member_2.member;
                    if (_e991 == 1u) {
                        if (_e983.member_1 < _e987.member_1) {
                            phi_1468_ = type_12(_e983.member_1, _e987.member_1);
                        } else {
                            phi_1468_ = type_12(_e987.member_1, _e983.member_1);
                        }
                        let _e998 = phi_1468_;
                        phi_1473_ = _e998;
                    } else {
                        phi_1473_ = type_12(_e983.member_1, _e987.member_1);
                    }
                    let _e1000 = phi_1473_;
                    let _e1003 = params.member.member_1.member_3;
                    let _e1004 = (_e784 + _e755);
                    if (_e1004 < _e1003) {
                        let _e1008 = (2u * _e1004);
                        atomicStore((&pairs.member[(4u + _e1008)]), _e1000.member);
                        atomicStore((&pairs.member[(_e1008 + 5u)]), _e1000.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_173_ = _e107;
            break if !(_e113);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
