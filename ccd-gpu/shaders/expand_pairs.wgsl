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
    member: type_7,
    member_1: type_8,
    member_2: type_8,
}

struct type_19 {
    member: type_18,
}

struct type_23 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> levels: type_23;
@group(0) @binding(5) 
var<storage, read_write> output: type_23;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_23;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_102_: array<u32, 2>;
    var phi_128_: u32;
    var phi_146_: u32;
    var phi_166_: u32;
    var phi_169_: type_9;
    var phi_170_: type_9;
    var phi_193_: type_9;
    var phi_303_: array<u32, 2>;
    var phi_339_: array<u32, 2>;
    var phi_349_: array<u32, 2>;
    var phi_351_: array<array<u32, 2>, 4>;
    var phi_352_: array<array<u32, 2>, 4>;
    var phi_353_: bool;
    var phi_354_: array<array<u32, 2>, 4>;
    var phi_355_: bool;
    var phi_367_: bool;
    var phi_372_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_420_: bool;
    var phi_425_: bool;
    var phi_435_: bool;
    var phi_436_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_544_: array<u32, 2>;
    var phi_574_: array<u32, 2>;
    var phi_604_: array<u32, 2>;
    var phi_634_: array<u32, 2>;
    var phi_636_: array<array<u32, 2>, 4>;
    var phi_637_: bool;
    var phi_638_: array<array<u32, 2>, 4>;
    var phi_639_: bool;
    var phi_798_: array<u32, 2>;
    var phi_830_: array<u32, 2>;
    var phi_705_: array<u32, 2>;
    var phi_737_: array<u32, 2>;
    var phi_832_: array<array<u32, 2>, 4>;
    var phi_833_: array<array<u32, 2>, 4>;
    var phi_834_: array<array<u32, 2>, 4>;
    var phi_835_: bool;
    var phi_836_: array<array<u32, 2>, 4>;
    var phi_837_: bool;
    var phi_841_: array<array<u32, 2>, 4>;
    var phi_842_: array<array<u32, 2>, 4>;
    var phi_843_: bool;
    var phi_847_: array<array<u32, 2>, 4>;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_869_: u32;
    var phi_870_: u32;
    var phi_876_: array<u32, 2>;
    var phi_877_: array<u32, 2>;
    var phi_878_: array<u32, 2>;
    var phi_879_: array<u32, 2>;
    var phi_880_: array<u32, 2>;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_901_: u32;
    var phi_902_: u32;
    var phi_911_: u32;
    var phi_914_: u32;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_935_: u32;
    var phi_936_: u32;
    var phi_945_: u32;
    var phi_948_: u32;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_969_: u32;
    var phi_970_: u32;
    var phi_979_: u32;
    var phi_982_: u32;
    var phi_998_: bool;
    var phi_999_: bool;
    var phi_1003_: u32;
    var phi_1004_: u32;
    var phi_1013_: u32;
    var phi_1016_: u32;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1087_: u32;
    var phi_1088_: u32;
    var phi_1151_: type_9;
    var phi_1156_: type_9;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1194_: u32;
    var phi_1195_: u32;
    var phi_1258_: type_9;
    var phi_1263_: type_9;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1301_: u32;
    var phi_1302_: u32;
    var phi_1365_: type_9;
    var phi_1370_: type_9;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1408_: u32;
    var phi_1409_: u32;
    var phi_1472_: type_9;
    var phi_1477_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e46 = (_e30.x * _e30.y);
    let _e49 = params.member.member_2.member;
    let _e52 = params.member.member_1.member_1;
    if (_e49 == 0u) {
        phi_102_ = array<u32, 2>(0u, 2u);
    } else {
        phi_102_ = array<u32, 2>(1u, 1u);
    }
    let _e55 = phi_102_;
    let _e61 = params.member.member.member[_e55[0]];
    let _e62 = (_e61 - 1u);
    let _e66 = params.member.member.member[_e55[1]];
    let _e67 = (_e66 - 1u);
    let _e70 = params.member.member_2.member_1;
    if (_e70 == 0u) {
        phi_128_ = 1u;
    } else {
        phi_128_ = 0u;
    }
    let _e73 = phi_128_;
    let _e75 = atomicLoad((&levels.member[_e52]));
    let _e78 = params.member.member_1.member_2;
    if (_e78 < _e75) {
        phi_146_ = _e78;
    } else {
        phi_146_ = _e75;
    }
    let _e81 = phi_146_;
    let _e84 = params.member.member_1.member_2;
    let _e85 = (_e46 * 128u);
    if (_e85 == 0u) {
        return;
    }
    let _e87 = (_e84 / _e85);
    if (_e85 == 0u) {
        return;
    }
    if ((_e84 % _e85) > 0u) {
        phi_166_ = (_e87 + 1u);
    } else {
        phi_166_ = _e87;
    }
    let _e93 = phi_166_;
    phi_169_ = type_9(0u, _e93);
    loop {
        let _e96 = phi_169_;
        if (_e96.member < _e96.member_1) {
            phi_170_ = type_9((_e96.member + 1u), _e96.member_1);
            phi_193_ = type_9(1u, _e96.member);
        } else {
            phi_170_ = _e96;
            phi_193_ = type_9(0u, type_9().member_1);
        }
        let _e108 = phi_170_;
        let _e110 = phi_193_;
        let _e114 = (bitcast<i32>(_e110.member) != 0i);
        if _e114 {
            let _e118 = (((((_e29.y * _e30.x) + _e29.x) + (_e110.member_1 * _e46)) * 128u) + _e31);
            if (_e31 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e118 < _e81) {
                let _e123 = (2u * _e118);
                let _e126 = input.member[(4u + _e123)];
                let _e129 = input.member[(_e123 + 5u)];
                let _e132 = a_nodes.member[_e126];
                let _e134 = b_nodes.member[_e129];
                if (_e49 == 1u) {
                    if (_e126 == _e129) {
                        if (_e132.member_3 == 4294967295u) {
                            phi_351_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        } else {
                            let _e140 = a_nodes.member[_e132.member_1];
                            let _e143 = a_nodes.member[_e132.member_3];
                            if !((_e140.member_3 == 4294967295u)) {
                                phi_303_ = array<u32, 2>(_e132.member_1, _e132.member_1);
                            } else {
                                phi_303_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e151 = phi_303_;
                            if ((((((_e140.member[0] <= _e143.member_2[0]) && (_e143.member[0] <= _e140.member_2[0])) && (_e140.member[1] <= _e143.member_2[1])) && (_e143.member[1] <= _e140.member_2[1])) && (_e140.member[2] <= _e143.member_2[2])) && (_e143.member[2] <= _e140.member_2[2])) {
                                phi_339_ = array<u32, 2>(_e132.member_1, _e132.member_3);
                            } else {
                                phi_339_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e183 = phi_339_;
                            if !((_e143.member_3 == 4294967295u)) {
                                phi_349_ = array<u32, 2>(_e132.member_3, _e132.member_3);
                            } else {
                                phi_349_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e191 = phi_349_;
                            phi_351_ = array<array<u32, 2>, 4>(_e151, _e183, _e191, array<u32, 2>(4294967295u, 4294967295u));
                        }
                        let _e194 = phi_351_;
                        phi_352_ = _e194;
                        phi_353_ = false;
                    } else {
                        phi_352_ = array<array<u32, 2>, 4>();
                        phi_353_ = true;
                    }
                    let _e196 = phi_352_;
                    let _e198 = phi_353_;
                    phi_354_ = _e196;
                    phi_355_ = _e198;
                } else {
                    phi_354_ = array<array<u32, 2>, 4>();
                    phi_355_ = true;
                }
                let _e200 = phi_354_;
                let _e202 = phi_355_;
                if _e202 {
                    if (_e132.member_3 == 4294967295u) {
                        phi_367_ = false;
                    } else {
                        phi_367_ = !((_e134.member_3 == 4294967295u));
                    }
                    let _e209 = phi_367_;
                    if _e209 {
                        phi_372_ = (_e73 == 1u);
                    } else {
                        phi_372_ = false;
                    }
                    let _e212 = phi_372_;
                    if _e212 {
                        phi_415_ = bool();
                        phi_416_ = true;
                    } else {
                        let _e214 = (_e132.member_3 == 4294967295u);
                        if _e214 {
                            phi_414_ = bool();
                        } else {
                            if _e209 {
                                phi_413_ = ((((_e134.member_2[0] - _e134.member[0]) * (_e134.member_2[1] - _e134.member[1])) * (_e134.member_2[2] - _e134.member[2])) > (((_e132.member_2[0] - _e132.member[0]) * (_e132.member_2[1] - _e132.member[1])) * (_e132.member_2[2] - _e132.member[2])));
                            } else {
                                phi_413_ = false;
                            }
                            let _e243 = phi_413_;
                            phi_414_ = _e243;
                        }
                        let _e245 = phi_414_;
                        phi_415_ = _e245;
                        phi_416_ = _e214;
                    }
                    let _e247 = phi_415_;
                    let _e249 = phi_416_;
                    if _e249 {
                        phi_420_ = true;
                    } else {
                        phi_420_ = _e247;
                    }
                    let _e251 = phi_420_;
                    if _e212 {
                        phi_425_ = true;
                    } else {
                        phi_425_ = !(_e251);
                    }
                    let _e254 = phi_425_;
                    if _e254 {
                        if (_e132.member_3 == 4294967295u) {
                            phi_435_ = false;
                        } else {
                            phi_435_ = true;
                        }
                        let _e258 = phi_435_;
                        phi_436_ = _e258;
                    } else {
                        phi_436_ = true;
                    }
                    let _e260 = phi_436_;
                    if _e260 {
                        if _e251 {
                            if (_e134.member_3 == 4294967295u) {
                                phi_448_ = false;
                            } else {
                                phi_448_ = true;
                            }
                            let _e264 = phi_448_;
                            phi_449_ = _e264;
                        } else {
                            phi_449_ = true;
                        }
                        let _e266 = phi_449_;
                        if _e266 {
                            if _e254 {
                                if _e251 {
                                    let _e269 = a_nodes.member[_e132.member_1];
                                    let _e274 = a_nodes.member[_e132.member_3];
                                    let _e279 = b_nodes.member[_e134.member_1];
                                    let _e284 = b_nodes.member[_e134.member_3];
                                    if ((((((_e269.member[0] <= _e279.member_2[0]) && (_e279.member[0] <= _e269.member_2[0])) && (_e269.member[1] <= _e279.member_2[1])) && (_e279.member[1] <= _e269.member_2[1])) && (_e269.member[2] <= _e279.member_2[2])) && (_e279.member[2] <= _e269.member_2[2])) {
                                        phi_544_ = array<u32, 2>(_e132.member_1, _e134.member_1);
                                    } else {
                                        phi_544_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e314 = phi_544_;
                                    if ((((((_e269.member[0] <= _e284.member_2[0]) && (_e284.member[0] <= _e269.member_2[0])) && (_e269.member[1] <= _e284.member_2[1])) && (_e284.member[1] <= _e269.member_2[1])) && (_e269.member[2] <= _e284.member_2[2])) && (_e284.member[2] <= _e269.member_2[2])) {
                                        phi_574_ = array<u32, 2>(_e132.member_1, _e134.member_3);
                                    } else {
                                        phi_574_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e342 = phi_574_;
                                    if ((((((_e274.member[0] <= _e279.member_2[0]) && (_e279.member[0] <= _e274.member_2[0])) && (_e274.member[1] <= _e279.member_2[1])) && (_e279.member[1] <= _e274.member_2[1])) && (_e274.member[2] <= _e279.member_2[2])) && (_e279.member[2] <= _e274.member_2[2])) {
                                        phi_604_ = array<u32, 2>(_e132.member_3, _e134.member_1);
                                    } else {
                                        phi_604_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e370 = phi_604_;
                                    if ((((((_e274.member[0] <= _e284.member_2[0]) && (_e284.member[0] <= _e274.member_2[0])) && (_e274.member[1] <= _e284.member_2[1])) && (_e284.member[1] <= _e274.member_2[1])) && (_e274.member[2] <= _e284.member_2[2])) && (_e284.member[2] <= _e274.member_2[2])) {
                                        phi_634_ = array<u32, 2>(_e132.member_3, _e134.member_3);
                                    } else {
                                        phi_634_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e398 = phi_634_;
                                    phi_636_ = array<array<u32, 2>, 4>(_e314, _e342, _e370, _e398);
                                    phi_637_ = false;
                                } else {
                                    phi_636_ = array<array<u32, 2>, 4>();
                                    phi_637_ = true;
                                }
                                let _e401 = phi_636_;
                                let _e403 = phi_637_;
                                phi_638_ = _e401;
                                phi_639_ = _e403;
                            } else {
                                phi_638_ = array<array<u32, 2>, 4>();
                                phi_639_ = true;
                            }
                            let _e405 = phi_638_;
                            let _e407 = phi_639_;
                            if _e407 {
                                if _e254 {
                                    let _e479 = a_nodes.member[_e132.member_1];
                                    let _e484 = a_nodes.member[_e132.member_3];
                                    if ((((((_e479.member[0] <= _e134.member_2[0]) && (_e134.member[0] <= _e479.member_2[0])) && (_e479.member[1] <= _e134.member_2[1])) && (_e134.member[1] <= _e479.member_2[1])) && (_e479.member[2] <= _e134.member_2[2])) && (_e134.member[2] <= _e479.member_2[2])) {
                                        phi_705_ = array<u32, 2>(_e132.member_1, _e129);
                                    } else {
                                        phi_705_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e515 = phi_705_;
                                    if ((((((_e484.member[0] <= _e134.member_2[0]) && (_e134.member[0] <= _e484.member_2[0])) && (_e484.member[1] <= _e134.member_2[1])) && (_e134.member[1] <= _e484.member_2[1])) && (_e484.member[2] <= _e134.member_2[2])) && (_e134.member[2] <= _e484.member_2[2])) {
                                        phi_737_ = array<u32, 2>(_e132.member_3, _e129);
                                    } else {
                                        phi_737_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e544 = phi_737_;
                                    phi_832_ = array<array<u32, 2>, 4>(_e515, _e544, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e410 = b_nodes.member[_e134.member_1];
                                    let _e415 = b_nodes.member[_e134.member_3];
                                    if ((((((_e132.member[0] <= _e410.member_2[0]) && (_e410.member[0] <= _e132.member_2[0])) && (_e132.member[1] <= _e410.member_2[1])) && (_e410.member[1] <= _e132.member_2[1])) && (_e132.member[2] <= _e410.member_2[2])) && (_e410.member[2] <= _e132.member_2[2])) {
                                        phi_798_ = array<u32, 2>(_e126, _e134.member_1);
                                    } else {
                                        phi_798_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e446 = phi_798_;
                                    if ((((((_e132.member[0] <= _e415.member_2[0]) && (_e415.member[0] <= _e132.member_2[0])) && (_e132.member[1] <= _e415.member_2[1])) && (_e415.member[1] <= _e132.member_2[1])) && (_e132.member[2] <= _e415.member_2[2])) && (_e415.member[2] <= _e132.member_2[2])) {
                                        phi_830_ = array<u32, 2>(_e126, _e134.member_3);
                                    } else {
                                        phi_830_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e475 = phi_830_;
                                    phi_832_ = array<array<u32, 2>, 4>(_e446, _e475, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e547 = phi_832_;
                                phi_833_ = _e547;
                            } else {
                                phi_833_ = _e405;
                            }
                            let _e549 = phi_833_;
                            phi_834_ = _e549;
                            phi_835_ = false;
                        } else {
                            phi_834_ = array<array<u32, 2>, 4>();
                            phi_835_ = true;
                        }
                        let _e551 = phi_834_;
                        let _e553 = phi_835_;
                        phi_836_ = _e551;
                        phi_837_ = _e553;
                    } else {
                        phi_836_ = array<array<u32, 2>, 4>();
                        phi_837_ = true;
                    }
                    let _e555 = phi_836_;
                    let _e557 = phi_837_;
                    phi_841_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                    phi_842_ = _e555;
                    phi_843_ = _e557;
                } else {
                    phi_841_ = _e200;
                    phi_842_ = array<array<u32, 2>, 4>();
                    phi_843_ = true;
                }
                let _e559 = phi_841_;
                let _e561 = phi_842_;
                let _e563 = phi_843_;
                if _e563 {
                    phi_847_ = _e559;
                } else {
                    phi_847_ = _e561;
                }
                let _e565 = phi_847_;
                if (_e126 == 4294967295u) {
                    phi_870_ = 0u;
                } else {
                    if (_e126 >= _e62) {
                        if (_e129 >= _e67) {
                            phi_864_ = false;
                        } else {
                            phi_864_ = true;
                        }
                        let _e574 = phi_864_;
                        phi_865_ = _e574;
                    } else {
                        phi_865_ = true;
                    }
                    let _e576 = phi_865_;
                    if _e576 {
                        phi_869_ = 1u;
                    } else {
                        phi_869_ = 2u;
                    }
                    let _e578 = phi_869_;
                    phi_870_ = _e578;
                }
                let _e580 = phi_870_;
                if (_e580 == 2u) {
                    phi_876_ = array<u32, 2>(_e126, _e129);
                } else {
                    phi_876_ = _e565[0];
                }
                let _e584 = phi_876_;
                phi_877_ = _e565[3];
                phi_878_ = _e565[2];
                phi_879_ = _e565[1];
                phi_880_ = _e584;
            } else {
                phi_877_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_878_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_879_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_880_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e586 = phi_877_;
            let _e588 = phi_878_;
            let _e590 = phi_879_;
            let _e592 = phi_880_;
            if (_e592[0] == 4294967295u) {
                phi_902_ = 0u;
            } else {
                if (_e592[0] >= _e62) {
                    if (_e592[1] >= _e67) {
                        phi_896_ = false;
                    } else {
                        phi_896_ = true;
                    }
                    let _e600 = phi_896_;
                    phi_897_ = _e600;
                } else {
                    phi_897_ = true;
                }
                let _e602 = phi_897_;
                if _e602 {
                    phi_901_ = 1u;
                } else {
                    phi_901_ = 2u;
                }
                let _e604 = phi_901_;
                phi_902_ = _e604;
            }
            let _e606 = phi_902_;
            if (_e606 == 0u) {
                phi_914_ = 0u;
            } else {
                if (_e606 == 1u) {
                    phi_911_ = 0u;
                } else {
                    phi_911_ = 1u;
                }
                let _e610 = phi_911_;
                let _e612 = atomicAdd((&counters[_e610]), 1u);
                phi_914_ = _e612;
            }
            let _e614 = phi_914_;
            if (_e590[0] == 4294967295u) {
                phi_936_ = 0u;
            } else {
                if (_e590[0] >= _e62) {
                    if (_e590[1] >= _e67) {
                        phi_930_ = false;
                    } else {
                        phi_930_ = true;
                    }
                    let _e622 = phi_930_;
                    phi_931_ = _e622;
                } else {
                    phi_931_ = true;
                }
                let _e624 = phi_931_;
                if _e624 {
                    phi_935_ = 1u;
                } else {
                    phi_935_ = 2u;
                }
                let _e626 = phi_935_;
                phi_936_ = _e626;
            }
            let _e628 = phi_936_;
            if (_e628 == 0u) {
                phi_948_ = 0u;
            } else {
                if (_e628 == 1u) {
                    phi_945_ = 0u;
                } else {
                    phi_945_ = 1u;
                }
                let _e632 = phi_945_;
                let _e634 = atomicAdd((&counters[_e632]), 1u);
                phi_948_ = _e634;
            }
            let _e636 = phi_948_;
            if (_e588[0] == 4294967295u) {
                phi_970_ = 0u;
            } else {
                if (_e588[0] >= _e62) {
                    if (_e588[1] >= _e67) {
                        phi_964_ = false;
                    } else {
                        phi_964_ = true;
                    }
                    let _e644 = phi_964_;
                    phi_965_ = _e644;
                } else {
                    phi_965_ = true;
                }
                let _e646 = phi_965_;
                if _e646 {
                    phi_969_ = 1u;
                } else {
                    phi_969_ = 2u;
                }
                let _e648 = phi_969_;
                phi_970_ = _e648;
            }
            let _e650 = phi_970_;
            if (_e650 == 0u) {
                phi_982_ = 0u;
            } else {
                if (_e650 == 1u) {
                    phi_979_ = 0u;
                } else {
                    phi_979_ = 1u;
                }
                let _e654 = phi_979_;
                let _e656 = atomicAdd((&counters[_e654]), 1u);
                phi_982_ = _e656;
            }
            let _e658 = phi_982_;
            if (_e586[0] == 4294967295u) {
                phi_1004_ = 0u;
            } else {
                if (_e586[0] >= _e62) {
                    if (_e586[1] >= _e67) {
                        phi_998_ = false;
                    } else {
                        phi_998_ = true;
                    }
                    let _e666 = phi_998_;
                    phi_999_ = _e666;
                } else {
                    phi_999_ = true;
                }
                let _e668 = phi_999_;
                if _e668 {
                    phi_1003_ = 1u;
                } else {
                    phi_1003_ = 2u;
                }
                let _e670 = phi_1003_;
                phi_1004_ = _e670;
            }
            let _e672 = phi_1004_;
            if (_e672 == 0u) {
                phi_1016_ = 0u;
            } else {
                if (_e672 == 1u) {
                    phi_1013_ = 0u;
                } else {
                    phi_1013_ = 1u;
                }
                let _e676 = phi_1013_;
                let _e678 = atomicAdd((&counters[_e676]), 1u);
                phi_1016_ = _e678;
            }
            let _e680 = phi_1016_;
            workgroupBarrier();
            if (_e31 == 0u) {
                let _e683 = atomicLoad((&counters[0u]));
                let _e685 = atomicLoad((&counters[1u]));
                if (_e683 > 0u) {
                    let _e689 = atomicAdd((&levels.member[(_e52 + 1u)]), _e683);
                    let _e692 = atomicMax((&output.member[0u]), (_e689 + _e683));
                    if ((_e689 + _e683) < _e689) {
                        let _e696 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e689);
                }
                if (_e685 > 0u) {
                    let _e700 = atomicAdd((&pairs.member[0u]), _e685);
                    if ((_e700 + _e685) < _e700) {
                        let _e704 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e700);
                }
            }
            workgroupBarrier();
            let _e707 = atomicLoad((&counters[2u]));
            let _e709 = atomicLoad((&counters[3u]));
            if (_e592[0] == 4294967295u) {
                phi_1088_ = 0u;
            } else {
                if (_e592[0] >= _e62) {
                    if (_e592[1] >= _e67) {
                        phi_1082_ = false;
                    } else {
                        phi_1082_ = true;
                    }
                    let _e717 = phi_1082_;
                    phi_1083_ = _e717;
                } else {
                    phi_1083_ = true;
                }
                let _e719 = phi_1083_;
                if _e719 {
                    phi_1087_ = 1u;
                } else {
                    phi_1087_ = 2u;
                }
                let _e721 = phi_1087_;
                phi_1088_ = _e721;
            }
            let _e723 = phi_1088_;
            if (_e723 == 1u) {
                let _e762 = params.member.member_2.member_3;
                let _e763 = (_e707 + _e614);
                if (_e763 < _e762) {
                    let _e765 = (2u * _e763);
                    atomicStore((&output.member[(4u + _e765)]), _e592[0]);
                    atomicStore((&output.member[(_e765 + 5u)]), _e592[1]);
                }
            } else {
                if (_e723 == 2u) {
                    let _e728 = a_nodes.member[_e592[0]];
                    let _e732 = b_nodes.member[_e592[1]];
                    let _e736 = params.member.member_2.member;
                    if (_e736 == 1u) {
                        if (_e728.member_1 < _e732.member_1) {
                            phi_1151_ = type_9(_e728.member_1, _e732.member_1);
                        } else {
                            phi_1151_ = type_9(_e732.member_1, _e728.member_1);
                        }
                        let _e743 = phi_1151_;
                        phi_1156_ = _e743;
                    } else {
                        phi_1156_ = type_9(_e728.member_1, _e732.member_1);
                    }
                    let _e745 = phi_1156_;
                    let _e748 = params.member.member_1.member_3;
                    let _e749 = (_e709 + _e614);
                    if (_e749 < _e748) {
                        let _e753 = (2u * _e749);
                        atomicStore((&pairs.member[(4u + _e753)]), _e745.member);
                        atomicStore((&pairs.member[(_e753 + 5u)]), _e745.member_1);
                    }
                }
            }
            if (_e590[0] == 4294967295u) {
                phi_1195_ = 0u;
            } else {
                if (_e590[0] >= _e62) {
                    if (_e590[1] >= _e67) {
                        phi_1189_ = false;
                    } else {
                        phi_1189_ = true;
                    }
                    let _e777 = phi_1189_;
                    phi_1190_ = _e777;
                } else {
                    phi_1190_ = true;
                }
                let _e779 = phi_1190_;
                if _e779 {
                    phi_1194_ = 1u;
                } else {
                    phi_1194_ = 2u;
                }
                let _e781 = phi_1194_;
                phi_1195_ = _e781;
            }
            let _e783 = phi_1195_;
            if (_e783 == 1u) {
                let _e822 = params.member.member_2.member_3;
                let _e823 = (_e707 + _e636);
                if (_e823 < _e822) {
                    let _e825 = (2u * _e823);
                    atomicStore((&output.member[(4u + _e825)]), _e590[0]);
                    atomicStore((&output.member[(_e825 + 5u)]), _e590[1]);
                }
            } else {
                if (_e783 == 2u) {
                    let _e788 = a_nodes.member[_e590[0]];
                    let _e792 = b_nodes.member[_e590[1]];
                    let _e796 = params.member.member_2.member;
                    if (_e796 == 1u) {
                        if (_e788.member_1 < _e792.member_1) {
                            phi_1258_ = type_9(_e788.member_1, _e792.member_1);
                        } else {
                            phi_1258_ = type_9(_e792.member_1, _e788.member_1);
                        }
                        let _e803 = phi_1258_;
                        phi_1263_ = _e803;
                    } else {
                        phi_1263_ = type_9(_e788.member_1, _e792.member_1);
                    }
                    let _e805 = phi_1263_;
                    let _e808 = params.member.member_1.member_3;
                    let _e809 = (_e709 + _e636);
                    if (_e809 < _e808) {
                        let _e813 = (2u * _e809);
                        atomicStore((&pairs.member[(4u + _e813)]), _e805.member);
                        atomicStore((&pairs.member[(_e813 + 5u)]), _e805.member_1);
                    }
                }
            }
            if (_e588[0] == 4294967295u) {
                phi_1302_ = 0u;
            } else {
                if (_e588[0] >= _e62) {
                    if (_e588[1] >= _e67) {
                        phi_1296_ = false;
                    } else {
                        phi_1296_ = true;
                    }
                    let _e837 = phi_1296_;
                    phi_1297_ = _e837;
                } else {
                    phi_1297_ = true;
                }
                let _e839 = phi_1297_;
                if _e839 {
                    phi_1301_ = 1u;
                } else {
                    phi_1301_ = 2u;
                }
                let _e841 = phi_1301_;
                phi_1302_ = _e841;
            }
            let _e843 = phi_1302_;
            if (_e843 == 1u) {
                let _e882 = params.member.member_2.member_3;
                let _e883 = (_e707 + _e658);
                if (_e883 < _e882) {
                    let _e885 = (2u * _e883);
                    atomicStore((&output.member[(4u + _e885)]), _e588[0]);
                    atomicStore((&output.member[(_e885 + 5u)]), _e588[1]);
                }
            } else {
                if (_e843 == 2u) {
                    let _e848 = a_nodes.member[_e588[0]];
                    let _e852 = b_nodes.member[_e588[1]];
                    let _e856 = params.member.member_2.member;
                    if (_e856 == 1u) {
                        if (_e848.member_1 < _e852.member_1) {
                            phi_1365_ = type_9(_e848.member_1, _e852.member_1);
                        } else {
                            phi_1365_ = type_9(_e852.member_1, _e848.member_1);
                        }
                        let _e863 = phi_1365_;
                        phi_1370_ = _e863;
                    } else {
                        phi_1370_ = type_9(_e848.member_1, _e852.member_1);
                    }
                    let _e865 = phi_1370_;
                    let _e868 = params.member.member_1.member_3;
                    let _e869 = (_e709 + _e658);
                    if (_e869 < _e868) {
                        let _e873 = (2u * _e869);
                        atomicStore((&pairs.member[(4u + _e873)]), _e865.member);
                        atomicStore((&pairs.member[(_e873 + 5u)]), _e865.member_1);
                    }
                }
            }
            if (_e586[0] == 4294967295u) {
                phi_1409_ = 0u;
            } else {
                if (_e586[0] >= _e62) {
                    if (_e586[1] >= _e67) {
                        phi_1403_ = false;
                    } else {
                        phi_1403_ = true;
                    }
                    let _e897 = phi_1403_;
                    phi_1404_ = _e897;
                } else {
                    phi_1404_ = true;
                }
                let _e899 = phi_1404_;
                if _e899 {
                    phi_1408_ = 1u;
                } else {
                    phi_1408_ = 2u;
                }
                let _e901 = phi_1408_;
                phi_1409_ = _e901;
            }
            let _e903 = phi_1409_;
            if (_e903 == 1u) {
                let _e942 = params.member.member_2.member_3;
                let _e943 = (_e707 + _e680);
                if (_e943 < _e942) {
                    let _e945 = (2u * _e943);
                    atomicStore((&output.member[(4u + _e945)]), _e586[0]);
                    atomicStore((&output.member[(_e945 + 5u)]), _e586[1]);
                }
            } else {
                if (_e903 == 2u) {
                    let _e908 = a_nodes.member[_e586[0]];
                    let _e912 = b_nodes.member[_e586[1]];
                    let _e916 = params.member.member_2.member;
                    if (_e916 == 1u) {
                        if (_e908.member_1 < _e912.member_1) {
                            phi_1472_ = type_9(_e908.member_1, _e912.member_1);
                        } else {
                            phi_1472_ = type_9(_e912.member_1, _e908.member_1);
                        }
                        let _e923 = phi_1472_;
                        phi_1477_ = _e923;
                    } else {
                        phi_1477_ = type_9(_e908.member_1, _e912.member_1);
                    }
                    let _e925 = phi_1477_;
                    let _e928 = params.member.member_1.member_3;
                    let _e929 = (_e709 + _e680);
                    if (_e929 < _e928) {
                        let _e933 = (2u * _e929);
                        atomicStore((&pairs.member[(4u + _e933)]), _e925.member);
                        atomicStore((&pairs.member[(_e933 + 5u)]), _e925.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_169_ = _e108;
            break if !(_e114);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
