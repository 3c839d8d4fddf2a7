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

struct type_14 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_17 {
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

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_21 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_29;
@group(0) @binding(3) 
var<storage> oriented: type_25;
@group(0) @binding(7) 
var<storage, read_write> front: type_11;
@group(0) @binding(4) 
var<storage, read_write> control: type_29;
@group(0) @binding(1) 
var<storage> a: type_16;
@group(0) @binding(2) 
var<storage> b: type_16;
var<workgroup> shared_: array<atomic<u32>, 22>;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_29;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_21;
    var phi_238_: array<u32, 2>;
    var phi_330_: array<u32, 2>;
    var phi_361_: array<u32, 2>;
    var phi_393_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_509_: f32;
    var phi_527_: f32;
    var phi_532_: f32;
    var phi_537_: f32;
    var phi_553_: type_26;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_635_: f32;
    var phi_641_: f32;
    var phi_647_: f32;
    var phi_653_: f32;
    var phi_671_: f32;
    var phi_676_: f32;
    var phi_681_: f32;
    var phi_697_: type_26;
    var phi_887_: f32;
    var phi_893_: f32;
    var phi_900_: f32;
    var phi_909_: f32;
    var phi_916_: f32;
    var phi_924_: f32;
    var phi_933_: f32;
    var phi_940_: f32;
    var phi_948_: f32;
    var phi_1041_: f32;
    var phi_1048_: f32;
    var phi_1054_: f32;
    var phi_1060_: f32;
    var phi_1079_: f32;
    var phi_1086_: f32;
    var phi_1092_: f32;
    var phi_1098_: f32;
    var phi_1117_: f32;
    var phi_1124_: f32;
    var phi_1130_: f32;
    var phi_1136_: f32;
    var phi_1155_: f32;
    var phi_1162_: f32;
    var phi_1168_: f32;
    var phi_1174_: f32;
    var phi_1193_: f32;
    var phi_1200_: f32;
    var phi_1206_: f32;
    var phi_1212_: f32;
    var phi_1231_: f32;
    var phi_1238_: f32;
    var phi_1244_: f32;
    var phi_1250_: f32;
    var phi_1265_: f32;
    var phi_1270_: f32;
    var phi_1275_: f32;
    var phi_1280_: f32;
    var phi_1285_: f32;
    var phi_1344_: f32;
    var phi_1367_: f32;
    var phi_1390_: f32;
    var phi_1412_: f32;
    var phi_1428_: f32;
    var phi_1483_: f32;
    var phi_1506_: f32;
    var phi_1529_: f32;
    var phi_1551_: f32;
    var phi_1567_: f32;
    var phi_1622_: f32;
    var phi_1645_: f32;
    var phi_1668_: f32;
    var phi_1690_: f32;
    var phi_1706_: f32;
    var phi_1761_: f32;
    var phi_1784_: f32;
    var phi_1808_: f32;
    var phi_1831_: f32;
    var phi_1847_: f32;
    var phi_1902_: f32;
    var phi_1925_: f32;
    var phi_1949_: f32;
    var phi_1972_: f32;
    var phi_1988_: f32;
    var phi_2043_: f32;
    var phi_2066_: f32;
    var phi_2090_: f32;
    var phi_2113_: f32;
    var phi_2129_: f32;
    var phi_2184_: f32;
    var phi_2207_: f32;
    var phi_2231_: f32;
    var phi_2254_: f32;
    var phi_2270_: f32;
    var phi_2325_: f32;
    var phi_2348_: f32;
    var phi_2372_: f32;
    var phi_2395_: f32;
    var phi_2411_: f32;
    var phi_2466_: f32;
    var phi_2489_: f32;
    var phi_2513_: f32;
    var phi_2536_: f32;
    var phi_2552_: f32;
    var phi_2559_: f32;
    var phi_2564_: f32;
    var phi_2569_: f32;
    var phi_2574_: f32;
    var phi_2579_: f32;
    var phi_2584_: f32;
    var phi_2589_: f32;
    var phi_2594_: f32;
    var phi_2598_: bool;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2607_: bool;
    var phi_2621_: array<u32, 2>;
    var phi_2657_: bool;
    var phi_2658_: bool;
    var phi_2662_: u32;
    var phi_2663_: u32;
    var phi_2664_: u32;
    var phi_2665_: u32;
    var phi_2666_: u32;
    var phi_2684_: array<u32, 2>;
    var phi_2685_: array<u32, 2>;
    var phi_2697_: array<u32, 2>;
    var phi_2698_: array<u32, 2>;
    var phi_2856_: type_9;
    var phi_2861_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e46 = id_2;
    let _e47 = n_2;
    let _e48 = lane_2;
    let _e63 = ((((_e46.y * _e47.x) + _e46.x) * 128u) + _e48);
    let _e65 = params.member.member_2;
    let _e67 = params.member.member_1;
    if (_e63 < _e67.member) {
        let _e75 = (2u * (((1u - _e65.member_5) * _e65.member_4) + _e63));
        let _e77 = front.member[_e75];
        let _e80 = front.member[(_e75 + 1u)];
        phi_238_ = array<u32, 2>(_e77, _e80);
    } else {
        phi_238_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e83 = phi_238_;
    if (_e48 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e83[0] != 4294967295u) {
        let _e92 = a.member[_e83[0]];
        let _e95 = b.member[_e83[1]];
        if ((((((_e92.member[0] <= _e95.member_2[0]) && (_e95.member[0] <= _e92.member_2[0])) && (_e92.member[1] <= _e95.member_2[1])) && (_e95.member[1] <= _e92.member_2[1])) && (_e92.member[2] <= _e95.member_2[2])) && (_e95.member[2] <= _e92.member_2[2])) {
            let _e125 = params.member.member_2.member;
            if (_e125 == 0u) {
                phi_330_ = array<u32, 2>(0u, 2u);
            } else {
                phi_330_ = array<u32, 2>(1u, 1u);
            }
            let _e128 = phi_330_;
            let _e134 = params.member.member.member[_e128[0]];
            let _e135 = (_e134 - 1u);
            let _e139 = params.member.member.member[_e128[1]];
            let _e140 = (_e139 - 1u);
            let _e143 = params.member.member_2.member;
            if (_e143 == 0u) {
                phi_361_ = array<u32, 2>(0u, 2u);
            } else {
                phi_361_ = array<u32, 2>(1u, 1u);
            }
            let _e146 = phi_361_;
            let _e152 = params.member.member.member_2[_e146[0]];
            let _e156 = params.member.member.member_2[_e146[1]];
            let _e159 = params.member.member_2.member;
            if (_e159 == 1u) {
                phi_393_ = (_e83[0] == _e83[1]);
            } else {
                phi_393_ = false;
            }
            let _e165 = phi_393_;
            if _e165 {
                phi_2602_ = bool();
                phi_2603_ = true;
            } else {
                if (_e83[0] >= _e135) {
                    if (_e83[1] >= _e140) {
                        phi_405_ = false;
                    } else {
                        phi_405_ = true;
                    }
                    let _e169 = phi_405_;
                    phi_406_ = _e169;
                } else {
                    phi_406_ = true;
                }
                let _e171 = phi_406_;
                if _e171 {
                    if (_e83[0] < _e135) {
                        let _e251 = oriented.member[(_e152 + _e83[0])];
                        phi_553_ = type_26(array<f32, 3>(_e251.member.x, _e251.member.y, _e251.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e251.member.w, _e251.member_1.x, _e251.member_1.y), array<f32, 3>(_e251.member_1.z, _e251.member_1.w, _e251.member_2.x), array<f32, 3>(_e251.member_2.y, _e251.member_2.z, _e251.member_2.w)), array<f32, 3>(_e251.member_3.x, _e251.member_3.y, _e251.member_3.z));
                    } else {
                        let _e174 = a.member[_e83[0]];
                        let _e189 = ((_e174.member[0] * 0.5f) + (_e174.member_2[0] * 0.5f));
                        let _e190 = ((_e174.member[1] * 0.5f) + (_e174.member_2[1] * 0.5f));
                        let _e191 = ((_e174.member[2] * 0.5f) + (_e174.member_2[2] * 0.5f));
                        if (_e189 < _e174.member_2[0]) {
                            phi_479_ = _e189;
                        } else {
                            phi_479_ = _e174.member_2[0];
                        }
                        let _e195 = phi_479_;
                        if (_e190 < _e174.member_2[1]) {
                            phi_485_ = _e190;
                        } else {
                            phi_485_ = _e174.member_2[1];
                        }
                        let _e199 = phi_485_;
                        if (_e191 < _e174.member_2[2]) {
                            phi_491_ = _e191;
                        } else {
                            phi_491_ = _e174.member_2[2];
                        }
                        let _e203 = phi_491_;
                        if (_e195 > _e174.member[0]) {
                            phi_497_ = _e195;
                        } else {
                            phi_497_ = _e174.member[0];
                        }
                        let _e207 = phi_497_;
                        if (_e199 > _e174.member[1]) {
                            phi_503_ = _e199;
                        } else {
                            phi_503_ = _e174.member[1];
                        }
                        let _e211 = phi_503_;
                        if (_e203 > _e174.member[2]) {
                            phi_509_ = _e203;
                        } else {
                            phi_509_ = _e174.member[2];
                        }
                        let _e215 = phi_509_;
                        let _e218 = (_e174.member_2[0] - _e207);
                        let _e220 = (_e174.member_2[1] - _e211);
                        let _e222 = (_e174.member_2[2] - _e215);
                        let _e224 = (_e207 - _e174.member[0]);
                        let _e226 = (_e211 - _e174.member[1]);
                        let _e228 = (_e215 - _e174.member[2]);
                        if (_e218 > _e224) {
                            phi_527_ = _e218;
                        } else {
                            phi_527_ = _e224;
                        }
                        let _e231 = phi_527_;
                        if (_e220 > _e226) {
                            phi_532_ = _e220;
                        } else {
                            phi_532_ = _e226;
                        }
                        let _e234 = phi_532_;
                        if (_e222 > _e228) {
                            phi_537_ = _e222;
                        } else {
                            phi_537_ = _e228;
                        }
                        let _e237 = phi_537_;
                        let _e239 = (1f + (0.000000059604645f * 4f));
                        let _e243 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_553_ = type_26(array<f32, 3>(_e207, _e211, _e215), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e231 * _e239) + _e243), ((_e234 * _e239) + _e243), ((_e237 * _e239) + _e243)));
                    }
                    let _e290 = phi_553_;
                    if (_e83[1] < _e140) {
                        let _e370 = oriented.member[(_e156 + _e83[1])];
                        phi_697_ = type_26(array<f32, 3>(_e370.member.x, _e370.member.y, _e370.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e370.member.w, _e370.member_1.x, _e370.member_1.y), array<f32, 3>(_e370.member_1.z, _e370.member_1.w, _e370.member_2.x), array<f32, 3>(_e370.member_2.y, _e370.member_2.z, _e370.member_2.w)), array<f32, 3>(_e370.member_3.x, _e370.member_3.y, _e370.member_3.z));
                    } else {
                        let _e293 = b.member[_e83[1]];
                        let _e308 = ((_e293.member[0] * 0.5f) + (_e293.member_2[0] * 0.5f));
                        let _e309 = ((_e293.member[1] * 0.5f) + (_e293.member_2[1] * 0.5f));
                        let _e310 = ((_e293.member[2] * 0.5f) + (_e293.member_2[2] * 0.5f));
                        if (_e308 < _e293.member_2[0]) {
                            phi_623_ = _e308;
                        } else {
                            phi_623_ = _e293.member_2[0];
                        }
                        let _e314 = phi_623_;
                        if (_e309 < _e293.member_2[1]) {
                            phi_629_ = _e309;
                        } else {
                            phi_629_ = _e293.member_2[1];
                        }
                        let _e318 = phi_629_;
                        if (_e310 < _e293.member_2[2]) {
                            phi_635_ = _e310;
                        } else {
                            phi_635_ = _e293.member_2[2];
                        }
                        let _e322 = phi_635_;
                        if (_e314 > _e293.member[0]) {
                            phi_641_ = _e314;
                        } else {
                            phi_641_ = _e293.member[0];
                        }
                        let _e326 = phi_641_;
                        if (_e318 > _e293.member[1]) {
                            phi_647_ = _e318;
                        } else {
                            phi_647_ = _e293.member[1];
                        }
                        let _e330 = phi_647_;
                        if (_e322 > _e293.member[2]) {
                            phi_653_ = _e322;
                        } else {
                            phi_653_ = _e293.member[2];
                        }
                        let _e334 = phi_653_;
                        let _e337 = (_e293.member_2[0] - _e326);
                        let _e339 = (_e293.member_2[1] - _e330);
                        let _e341 = (_e293.member_2[2] - _e334);
                        let _e343 = (_e326 - _e293.member[0]);
                        let _e345 = (_e330 - _e293.member[1]);
                        let _e347 = (_e334 - _e293.member[2]);
                        if (_e337 > _e343) {
                            phi_671_ = _e337;
                        } else {
                            phi_671_ = _e343;
                        }
                        let _e350 = phi_671_;
                        if (_e339 > _e345) {
                            phi_676_ = _e339;
                        } else {
                            phi_676_ = _e345;
                        }
                        let _e353 = phi_676_;
                        if (_e341 > _e347) {
                            phi_681_ = _e341;
                        } else {
                            phi_681_ = _e347;
                        }
                        let _e356 = phi_681_;
                        let _e358 = (1f + (0.000000059604645f * 4f));
                        let _e362 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_697_ = type_26(array<f32, 3>(_e326, _e330, _e334), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e350 * _e358) + _e362), ((_e353 * _e358) + _e362), ((_e356 * _e358) + _e362)));
                    }
                    let _e409 = phi_697_;
                    let _e414 = (_e409.member[0] - _e290.member[0]);
                    let _e417 = (_e409.member[1] - _e290.member[1]);
                    let _e420 = (_e409.member[2] - _e290.member[2]);
                    if (_e414 < 0f) {
                        phi_887_ = -(_e414);
                    } else {
                        phi_887_ = _e414;
                    }
                    let _e609 = phi_887_;
                    if (_e417 < 0f) {
                        phi_893_ = -(_e417);
                    } else {
                        phi_893_ = _e417;
                    }
                    let _e613 = phi_893_;
                    if (_e420 < 0f) {
                        phi_900_ = -(_e420);
                    } else {
                        phi_900_ = _e420;
                    }
                    let _e618 = phi_900_;
                    if (_e290.member_2[0] < 0f) {
                        phi_909_ = -(_e290.member_2[0]);
                    } else {
                        phi_909_ = _e290.member_2[0];
                    }
                    let _e625 = phi_909_;
                    if (_e290.member_2[1] < 0f) {
                        phi_916_ = -(_e290.member_2[1]);
                    } else {
                        phi_916_ = _e290.member_2[1];
                    }
                    let _e630 = phi_916_;
                    if (_e290.member_2[2] < 0f) {
                        phi_924_ = -(_e290.member_2[2]);
                    } else {
                        phi_924_ = _e290.member_2[2];
                    }
                    let _e636 = phi_924_;
                    if (_e409.member_2[0] < 0f) {
                        phi_933_ = -(_e409.member_2[0]);
                    } else {
                        phi_933_ = _e409.member_2[0];
                    }
                    let _e643 = phi_933_;
                    if (_e409.member_2[1] < 0f) {
                        phi_940_ = -(_e409.member_2[1]);
                    } else {
                        phi_940_ = _e409.member_2[1];
                    }
                    let _e648 = phi_940_;
                    if (_e409.member_2[2] < 0f) {
                        phi_948_ = -(_e409.member_2[2]);
                    } else {
                        phi_948_ = _e409.member_2[2];
                    }
                    let _e654 = phi_948_;
                    local = type_21(array<array<f32, 3>, 3>(array<f32, 3>((((_e409.member_1[0][0] * _e290.member_1[0][0]) + (_e409.member_1[0][1] * _e290.member_1[0][1])) + (_e409.member_1[0][2] * _e290.member_1[0][2])), (((_e409.member_1[1][0] * _e290.member_1[0][0]) + (_e409.member_1[1][1] * _e290.member_1[0][1])) + (_e409.member_1[1][2] * _e290.member_1[0][2])), (((_e409.member_1[2][0] * _e290.member_1[0][0]) + (_e409.member_1[2][1] * _e290.member_1[0][1])) + (_e409.member_1[2][2] * _e290.member_1[0][2]))), array<f32, 3>((((_e409.member_1[0][0] * _e290.member_1[1][0]) + (_e409.member_1[0][1] * _e290.member_1[1][1])) + (_e409.member_1[0][2] * _e290.member_1[1][2])), (((_e409.member_1[1][0] * _e290.member_1[1][0]) + (_e409.member_1[1][1] * _e290.member_1[1][1])) + (_e409.member_1[1][2] * _e290.member_1[1][2])), (((_e409.member_1[2][0] * _e290.member_1[1][0]) + (_e409.member_1[2][1] * _e290.member_1[1][1])) + (_e409.member_1[2][2] * _e290.member_1[1][2]))), array<f32, 3>((((_e409.member_1[0][0] * _e290.member_1[2][0]) + (_e409.member_1[0][1] * _e290.member_1[2][1])) + (_e409.member_1[0][2] * _e290.member_1[2][2])), (((_e409.member_1[1][0] * _e290.member_1[2][0]) + (_e409.member_1[1][1] * _e290.member_1[2][1])) + (_e409.member_1[1][2] * _e290.member_1[2][2])), (((_e409.member_1[2][0] * _e290.member_1[2][0]) + (_e409.member_1[2][1] * _e290.member_1[2][1])) + (_e409.member_1[2][2] * _e290.member_1[2][2])))), array<f32, 3>((((_e290.member_1[0][0] * _e414) + (_e290.member_1[0][1] * _e417)) + (_e290.member_1[0][2] * _e420)), (((_e290.member_1[1][0] * _e414) + (_e290.member_1[1][1] * _e417)) + (_e290.member_1[1][2] * _e420)), (((_e290.member_1[2][0] * _e414) + (_e290.member_1[2][1] * _e417)) + (_e290.member_1[2][2] * _e420))), array<f32, 3>((((_e409.member_1[0][0] * _e414) + (_e409.member_1[0][1] * _e417)) + (_e409.member_1[0][2] * _e420)), (((_e409.member_1[1][0] * _e414) + (_e409.member_1[1][1] * _e417)) + (_e409.member_1[1][2] * _e420)), (((_e409.member_1[2][0] * _e414) + (_e409.member_1[2][1] * _e417)) + (_e409.member_1[2][2] * _e420))), array<f32, 3>(_e290.member_2[0], _e290.member_2[1], _e290.member_2[2]), array<f32, 3>(_e409.member_2[0], _e409.member_2[1], _e409.member_2[2]), ((((((_e609 + _e613) + _e618) + (((_e625 + _e630) + _e636) + ((_e643 + _e648) + _e654))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e681 = local.member[0u][0u];
                    let _e685 = local.member[0u][1u];
                    let _e689 = local.member[0u][2u];
                    let _e693 = local.member[1u][0u];
                    let _e697 = local.member[1u][1u];
                    let _e701 = local.member[1u][2u];
                    let _e705 = local.member[2u][0u];
                    let _e709 = local.member[2u][1u];
                    let _e713 = local.member[2u][2u];
                    let _e715 = local.member_3;
                    let _e720 = local.member_4;
                    let _e726 = local.member_1[0u];
                    if (_e726 < 0f) {
                        phi_1041_ = -(_e726);
                    } else {
                        phi_1041_ = _e726;
                    }
                    let _e730 = phi_1041_;
                    if (_e681 < 0f) {
                        phi_1048_ = -(_e681);
                    } else {
                        phi_1048_ = _e681;
                    }
                    let _e734 = phi_1048_;
                    if (_e685 < 0f) {
                        phi_1054_ = -(_e685);
                    } else {
                        phi_1054_ = _e685;
                    }
                    let _e738 = phi_1054_;
                    if (_e689 < 0f) {
                        phi_1060_ = -(_e689);
                    } else {
                        phi_1060_ = _e689;
                    }
                    let _e742 = phi_1060_;
                    let _e749 = (_e730 - (_e715[0] + (((_e734 * _e720[0]) + (_e738 * _e720[1])) + (_e742 * _e720[2]))));
                    let _e752 = local.member_1[1u];
                    if (_e752 < 0f) {
                        phi_1079_ = -(_e752);
                    } else {
                        phi_1079_ = _e752;
                    }
                    let _e756 = phi_1079_;
                    if (_e693 < 0f) {
                        phi_1086_ = -(_e693);
                    } else {
                        phi_1086_ = _e693;
                    }
                    let _e760 = phi_1086_;
                    if (_e697 < 0f) {
                        phi_1092_ = -(_e697);
                    } else {
                        phi_1092_ = _e697;
                    }
                    let _e764 = phi_1092_;
                    if (_e701 < 0f) {
                        phi_1098_ = -(_e701);
                    } else {
                        phi_1098_ = _e701;
                    }
                    let _e768 = phi_1098_;
                    let _e775 = (_e756 - (_e715[1] + (((_e760 * _e720[0]) + (_e764 * _e720[1])) + (_e768 * _e720[2]))));
                    let _e778 = local.member_1[2u];
                    if (_e778 < 0f) {
                        phi_1117_ = -(_e778);
                    } else {
                        phi_1117_ = _e778;
                    }
                    let _e782 = phi_1117_;
                    if (_e705 < 0f) {
                        phi_1124_ = -(_e705);
                    } else {
                        phi_1124_ = _e705;
                    }
                    let _e786 = phi_1124_;
                    if (_e709 < 0f) {
                        phi_1130_ = -(_e709);
                    } else {
                        phi_1130_ = _e709;
                    }
                    let _e790 = phi_1130_;
                    if (_e713 < 0f) {
                        phi_1136_ = -(_e713);
                    } else {
                        phi_1136_ = _e713;
                    }
                    let _e794 = phi_1136_;
                    let _e801 = (_e782 - (_e715[2] + (((_e786 * _e720[0]) + (_e790 * _e720[1])) + (_e794 * _e720[2]))));
                    let _e804 = local.member_2[0u];
                    if (_e804 < 0f) {
                        phi_1155_ = -(_e804);
                    } else {
                        phi_1155_ = _e804;
                    }
                    let _e808 = phi_1155_;
                    if (_e681 < 0f) {
                        phi_1162_ = -(_e681);
                    } else {
                        phi_1162_ = _e681;
                    }
                    let _e812 = phi_1162_;
                    if (_e693 < 0f) {
                        phi_1168_ = -(_e693);
                    } else {
                        phi_1168_ = _e693;
                    }
                    let _e816 = phi_1168_;
                    if (_e705 < 0f) {
                        phi_1174_ = -(_e705);
                    } else {
                        phi_1174_ = _e705;
                    }
                    let _e820 = phi_1174_;
                    let _e827 = (_e808 - (_e720[0] + (((_e812 * _e715[0]) + (_e816 * _e715[1])) + (_e820 * _e715[2]))));
                    let _e830 = local.member_2[1u];
                    if (_e830 < 0f) {
                        phi_1193_ = -(_e830);
                    } else {
                        phi_1193_ = _e830;
                    }
                    let _e834 = phi_1193_;
                    if (_e685 < 0f) {
                        phi_1200_ = -(_e685);
                    } else {
                        phi_1200_ = _e685;
                    }
                    let _e838 = phi_1200_;
                    if (_e697 < 0f) {
                        phi_1206_ = -(_e697);
                    } else {
                        phi_1206_ = _e697;
                    }
                    let _e842 = phi_1206_;
                    if (_e709 < 0f) {
                        phi_1212_ = -(_e709);
                    } else {
                        phi_1212_ = _e709;
                    }
                    let _e846 = phi_1212_;
                    let _e853 = (_e834 - (_e720[1] + (((_e838 * _e715[0]) + (_e842 * _e715[1])) + (_e846 * _e715[2]))));
                    let _e856 = local.member_2[2u];
                    if (_e856 < 0f) {
                        phi_1231_ = -(_e856);
                    } else {
                        phi_1231_ = _e856;
                    }
                    let _e860 = phi_1231_;
                    if (_e689 < 0f) {
                        phi_1238_ = -(_e689);
                    } else {
                        phi_1238_ = _e689;
                    }
                    let _e864 = phi_1238_;
                    if (_e701 < 0f) {
                        phi_1244_ = -(_e701);
                    } else {
                        phi_1244_ = _e701;
                    }
                    let _e868 = phi_1244_;
                    if (_e713 < 0f) {
                        phi_1250_ = -(_e713);
                    } else {
                        phi_1250_ = _e713;
                    }
                    let _e872 = phi_1250_;
                    let _e879 = (_e860 - (_e720[2] + (((_e864 * _e715[0]) + (_e868 * _e715[1])) + (_e872 * _e715[2]))));
                    if (_e749 > _e775) {
                        phi_1265_ = _e749;
                    } else {
                        phi_1265_ = _e775;
                    }
                    let _e882 = phi_1265_;
                    if (_e882 > _e801) {
                        phi_1270_ = _e882;
                    } else {
                        phi_1270_ = _e801;
                    }
                    let _e885 = phi_1270_;
                    if (_e827 > _e853) {
                        phi_1275_ = _e827;
                    } else {
                        phi_1275_ = _e853;
                    }
                    let _e888 = phi_1275_;
                    if (_e888 > _e879) {
                        phi_1280_ = _e888;
                    } else {
                        phi_1280_ = _e879;
                    }
                    let _e891 = phi_1280_;
                    if (_e885 > _e891) {
                        phi_1285_ = _e885;
                    } else {
                        phi_1285_ = _e891;
                    }
                    let _e894 = phi_1285_;
                    let _e896 = local.member_5;
                    if (_e894 > _e896) {
                        phi_2598_ = true;
                    } else {
                        let _e901 = local.member[1u][0u];
                        let _e904 = local.member_1[2u];
                        let _e909 = local.member[2u][0u];
                        let _e912 = local.member_1[1u];
                        let _e914 = ((_e901 * _e904) - (_e909 * _e912));
                        let _e918 = local.member[2u][0u];
                        if (_e918 < 0f) {
                            phi_1344_ = -(_e918);
                        } else {
                            phi_1344_ = _e918;
                        }
                        let _e922 = phi_1344_;
                        let _e925 = local.member_3[1u];
                        let _e930 = local.member[1u][0u];
                        if (_e930 < 0f) {
                            phi_1367_ = -(_e930);
                        } else {
                            phi_1367_ = _e930;
                        }
                        let _e934 = phi_1367_;
                        let _e937 = local.member_3[2u];
                        let _e943 = local.member[0u][2u];
                        if (_e943 < 0f) {
                            phi_1390_ = -(_e943);
                        } else {
                            phi_1390_ = _e943;
                        }
                        let _e947 = phi_1390_;
                        let _e950 = local.member_4[1u];
                        let _e955 = local.member[0u][1u];
                        if (_e955 < 0f) {
                            phi_1412_ = -(_e955);
                        } else {
                            phi_1412_ = _e955;
                        }
                        let _e959 = phi_1412_;
                        let _e962 = local.member_4[2u];
                        if (_e914 < 0f) {
                            phi_1428_ = -(_e914);
                        } else {
                            phi_1428_ = _e914;
                        }
                        let _e968 = phi_1428_;
                        let _e970 = (_e968 - (((_e922 * _e925) + (_e934 * _e937)) + ((_e947 * _e950) + (_e959 * _e962))));
                        let _e974 = local.member[1u][1u];
                        let _e977 = local.member_1[2u];
                        let _e982 = local.member[2u][1u];
                        let _e985 = local.member_1[1u];
                        let _e987 = ((_e974 * _e977) - (_e982 * _e985));
                        let _e991 = local.member[2u][1u];
                        if (_e991 < 0f) {
                            phi_1483_ = -(_e991);
                        } else {
                            phi_1483_ = _e991;
                        }
                        let _e995 = phi_1483_;
                        let _e998 = local.member_3[1u];
                        let _e1003 = local.member[1u][1u];
                        if (_e1003 < 0f) {
                            phi_1506_ = -(_e1003);
                        } else {
                            phi_1506_ = _e1003;
                        }
                        let _e1007 = phi_1506_;
                        let _e1010 = local.member_3[2u];
                        let _e1016 = local.member[0u][0u];
                        if (_e1016 < 0f) {
                            phi_1529_ = -(_e1016);
                        } else {
                            phi_1529_ = _e1016;
                        }
                        let _e1020 = phi_1529_;
                        let _e1023 = local.member_4[2u];
                        let _e1028 = local.member[0u][2u];
                        if (_e1028 < 0f) {
                            phi_1551_ = -(_e1028);
                        } else {
                            phi_1551_ = _e1028;
                        }
                        let _e1032 = phi_1551_;
                        let _e1035 = local.member_4[0u];
                        if (_e987 < 0f) {
                            phi_1567_ = -(_e987);
                        } else {
                            phi_1567_ = _e987;
                        }
                        let _e1041 = phi_1567_;
                        let _e1043 = (_e1041 - (((_e995 * _e998) + (_e1007 * _e1010)) + ((_e1020 * _e1023) + (_e1032 * _e1035))));
                        let _e1047 = local.member[1u][2u];
                        let _e1050 = local.member_1[2u];
                        let _e1055 = local.member[2u][2u];
                        let _e1058 = local.member_1[1u];
                        let _e1060 = ((_e1047 * _e1050) - (_e1055 * _e1058));
                        let _e1064 = local.member[2u][2u];
                        if (_e1064 < 0f) {
                            phi_1622_ = -(_e1064);
                        } else {
                            phi_1622_ = _e1064;
                        }
                        let _e1068 = phi_1622_;
                        let _e1071 = local.member_3[1u];
                        let _e1076 = local.member[1u][2u];
                        if (_e1076 < 0f) {
                            phi_1645_ = -(_e1076);
                        } else {
                            phi_1645_ = _e1076;
                        }
                        let _e1080 = phi_1645_;
                        let _e1083 = local.member_3[2u];
                        let _e1089 = local.member[0u][1u];
                        if (_e1089 < 0f) {
                            phi_1668_ = -(_e1089);
                        } else {
                            phi_1668_ = _e1089;
                        }
                        let _e1093 = phi_1668_;
                        let _e1096 = local.member_4[0u];
                        let _e1101 = local.member[0u][0u];
                        if (_e1101 < 0f) {
                            phi_1690_ = -(_e1101);
                        } else {
                            phi_1690_ = _e1101;
                        }
                        let _e1105 = phi_1690_;
                        let _e1108 = local.member_4[1u];
                        if (_e1060 < 0f) {
                            phi_1706_ = -(_e1060);
                        } else {
                            phi_1706_ = _e1060;
                        }
                        let _e1114 = phi_1706_;
                        let _e1116 = (_e1114 - (((_e1068 * _e1071) + (_e1080 * _e1083)) + ((_e1093 * _e1096) + (_e1105 * _e1108))));
                        let _e1120 = local.member[2u][0u];
                        let _e1123 = local.member_1[0u];
                        let _e1128 = local.member[0u][0u];
                        let _e1131 = local.member_1[2u];
                        let _e1133 = ((_e1120 * _e1123) - (_e1128 * _e1131));
                        let _e1137 = local.member[0u][0u];
                        if (_e1137 < 0f) {
                            phi_1761_ = -(_e1137);
                        } else {
                            phi_1761_ = _e1137;
                        }
                        let _e1141 = phi_1761_;
                        let _e1144 = local.member_3[2u];
                        let _e1149 = local.member[2u][0u];
                        if (_e1149 < 0f) {
                            phi_1784_ = -(_e1149);
                        } else {
                            phi_1784_ = _e1149;
                        }
                        let _e1153 = phi_1784_;
                        let _e1156 = local.member_3[0u];
                        let _e1162 = local.member[1u][2u];
                        if (_e1162 < 0f) {
                            phi_1808_ = -(_e1162);
                        } else {
                            phi_1808_ = _e1162;
                        }
                        let _e1166 = phi_1808_;
                        let _e1169 = local.member_4[1u];
                        let _e1174 = local.member[1u][1u];
                        if (_e1174 < 0f) {
                            phi_1831_ = -(_e1174);
                        } else {
                            phi_1831_ = _e1174;
                        }
                        let _e1178 = phi_1831_;
                        let _e1181 = local.member_4[2u];
                        if (_e1133 < 0f) {
                            phi_1847_ = -(_e1133);
                        } else {
                            phi_1847_ = _e1133;
                        }
                        let _e1187 = phi_1847_;
                        let _e1189 = (_e1187 - (((_e1141 * _e1144) + (_e1153 * _e1156)) + ((_e1166 * _e1169) + (_e1178 * _e1181))));
                        let _e1193 = local.member[2u][1u];
                        let _e1196 = local.member_1[0u];
                        let _e1201 = local.member[0u][1u];
                        let _e1204 = local.member_1[2u];
                        let _e1206 = ((_e1193 * _e1196) - (_e1201 * _e1204));
                        let _e1210 = local.member[0u][1u];
                        if (_e1210 < 0f) {
                            phi_1902_ = -(_e1210);
                        } else {
                            phi_1902_ = _e1210;
                        }
                        let _e1214 = phi_1902_;
                        let _e1217 = local.member_3[2u];
                        let _e1222 = local.member[2u][1u];
                        if (_e1222 < 0f) {
                            phi_1925_ = -(_e1222);
                        } else {
                            phi_1925_ = _e1222;
                        }
                        let _e1226 = phi_1925_;
                        let _e1229 = local.member_3[0u];
                        let _e1235 = local.member[1u][0u];
                        if (_e1235 < 0f) {
                            phi_1949_ = -(_e1235);
                        } else {
                            phi_1949_ = _e1235;
                        }
                        let _e1239 = phi_1949_;
                        let _e1242 = local.member_4[2u];
                        let _e1247 = local.member[1u][2u];
                        if (_e1247 < 0f) {
                            phi_1972_ = -(_e1247);
                        } else {
                            phi_1972_ = _e1247;
                        }
                        let _e1251 = phi_1972_;
                        let _e1254 = local.member_4[0u];
                        if (_e1206 < 0f) {
                            phi_1988_ = -(_e1206);
                        } else {
                            phi_1988_ = _e1206;
                        }
                        let _e1260 = phi_1988_;
                        let _e1262 = (_e1260 - (((_e1214 * _e1217) + (_e1226 * _e1229)) + ((_e1239 * _e1242) + (_e1251 * _e1254))));
                        let _e1266 = local.member[2u][2u];
                        let _e1269 = local.member_1[0u];
                        let _e1274 = local.member[0u][2u];
                        let _e1277 = local.member_1[2u];
                        let _e1279 = ((_e1266 * _e1269) - (_e1274 * _e1277));
                        let _e1283 = local.member[0u][2u];
                        if (_e1283 < 0f) {
                            phi_2043_ = -(_e1283);
                        } else {
                            phi_2043_ = _e1283;
                        }
                        let _e1287 = phi_2043_;
                        let _e1290 = local.member_3[2u];
                        let _e1295 = local.member[2u][2u];
                        if (_e1295 < 0f) {
                            phi_2066_ = -(_e1295);
                        } else {
                            phi_2066_ = _e1295;
                        }
                        let _e1299 = phi_2066_;
                        let _e1302 = local.member_3[0u];
                        let _e1308 = local.member[1u][1u];
                        if (_e1308 < 0f) {
                            phi_2090_ = -(_e1308);
                        } else {
                            phi_2090_ = _e1308;
                        }
                        let _e1312 = phi_2090_;
                        let _e1315 = local.member_4[0u];
                        let _e1320 = local.member[1u][0u];
                        if (_e1320 < 0f) {
                            phi_2113_ = -(_e1320);
                        } else {
                            phi_2113_ = _e1320;
                        }
                        let _e1324 = phi_2113_;
                        let _e1327 = local.member_4[1u];
                        if (_e1279 < 0f) {
                            phi_2129_ = -(_e1279);
                        } else {
                            phi_2129_ = _e1279;
                        }
                        let _e1333 = phi_2129_;
                        let _e1335 = (_e1333 - (((_e1287 * _e1290) + (_e1299 * _e1302)) + ((_e1312 * _e1315) + (_e1324 * _e1327))));
                        let _e1339 = local.member[0u][0u];
                        let _e1342 = local.member_1[1u];
                        let _e1347 = local.member[1u][0u];
                        let _e1350 = local.member_1[0u];
                        let _e1352 = ((_e1339 * _e1342) - (_e1347 * _e1350));
                        let _e1356 = local.member[1u][0u];
                        if (_e1356 < 0f) {
                            phi_2184_ = -(_e1356);
                        } else {
                            phi_2184_ = _e1356;
                        }
                        let _e1360 = phi_2184_;
                        let _e1363 = local.member_3[0u];
                        let _e1368 = local.member[0u][0u];
                        if (_e1368 < 0f) {
                            phi_2207_ = -(_e1368);
                        } else {
                            phi_2207_ = _e1368;
                        }
                        let _e1372 = phi_2207_;
                        let _e1375 = local.member_3[1u];
                        let _e1381 = local.member[2u][2u];
                        if (_e1381 < 0f) {
                            phi_2231_ = -(_e1381);
                        } else {
                            phi_2231_ = _e1381;
                        }
                        let _e1385 = phi_2231_;
                        let _e1388 = local.member_4[1u];
                        let _e1393 = local.member[2u][1u];
                        if (_e1393 < 0f) {
                            phi_2254_ = -(_e1393);
                        } else {
                            phi_2254_ = _e1393;
                        }
                        let _e1397 = phi_2254_;
                        let _e1400 = local.member_4[2u];
                        if (_e1352 < 0f) {
                            phi_2270_ = -(_e1352);
                        } else {
                            phi_2270_ = _e1352;
                        }
                        let _e1406 = phi_2270_;
                        let _e1408 = (_e1406 - (((_e1360 * _e1363) + (_e1372 * _e1375)) + ((_e1385 * _e1388) + (_e1397 * _e1400))));
                        let _e1412 = local.member[0u][1u];
                        let _e1415 = local.member_1[1u];
                        let _e1420 = local.member[1u][1u];
                        let _e1423 = local.member_1[0u];
                        let _e1425 = ((_e1412 * _e1415) - (_e1420 * _e1423));
                        let _e1429 = local.member[1u][1u];
                        if (_e1429 < 0f) {
                            phi_2325_ = -(_e1429);
                        } else {
                            phi_2325_ = _e1429;
                        }
                        let _e1433 = phi_2325_;
                        let _e1436 = local.member_3[0u];
                        let _e1441 = local.member[0u][1u];
                        if (_e1441 < 0f) {
                            phi_2348_ = -(_e1441);
                        } else {
                            phi_2348_ = _e1441;
                        }
                        let _e1445 = phi_2348_;
                        let _e1448 = local.member_3[1u];
                        let _e1454 = local.member[2u][0u];
                        if (_e1454 < 0f) {
                            phi_2372_ = -(_e1454);
                        } else {
                            phi_2372_ = _e1454;
                        }
                        let _e1458 = phi_2372_;
                        let _e1461 = local.member_4[2u];
                        let _e1466 = local.member[2u][2u];
                        if (_e1466 < 0f) {
                            phi_2395_ = -(_e1466);
                        } else {
                            phi_2395_ = _e1466;
                        }
                        let _e1470 = phi_2395_;
                        let _e1473 = local.member_4[0u];
                        if (_e1425 < 0f) {
                            phi_2411_ = -(_e1425);
                        } else {
                            phi_2411_ = _e1425;
                        }
                        let _e1479 = phi_2411_;
                        let _e1481 = (_e1479 - (((_e1433 * _e1436) + (_e1445 * _e1448)) + ((_e1458 * _e1461) + (_e1470 * _e1473))));
                        let _e1485 = local.member[0u][2u];
                        let _e1488 = local.member_1[1u];
                        let _e1493 = local.member[1u][2u];
                        let _e1496 = local.member_1[0u];
                        let _e1498 = ((_e1485 * _e1488) - (_e1493 * _e1496));
                        let _e1502 = local.member[1u][2u];
                        if (_e1502 < 0f) {
                            phi_2466_ = -(_e1502);
                        } else {
                            phi_2466_ = _e1502;
                        }
                        let _e1506 = phi_2466_;
                        let _e1509 = local.member_3[0u];
                        let _e1514 = local.member[0u][2u];
                        if (_e1514 < 0f) {
                            phi_2489_ = -(_e1514);
                        } else {
                            phi_2489_ = _e1514;
                        }
                        let _e1518 = phi_2489_;
                        let _e1521 = local.member_3[1u];
                        let _e1527 = local.member[2u][1u];
                        if (_e1527 < 0f) {
                            phi_2513_ = -(_e1527);
                        } else {
                            phi_2513_ = _e1527;
                        }
                        let _e1531 = phi_2513_;
                        let _e1534 = local.member_4[0u];
                        let _e1539 = local.member[2u][0u];
                        if (_e1539 < 0f) {
                            phi_2536_ = -(_e1539);
                        } else {
                            phi_2536_ = _e1539;
                        }
                        let _e1543 = phi_2536_;
                        let _e1546 = local.member_4[1u];
                        if (_e1498 < 0f) {
                            phi_2552_ = -(_e1498);
                        } else {
                            phi_2552_ = _e1498;
                        }
                        let _e1552 = phi_2552_;
                        let _e1554 = (_e1552 - (((_e1506 * _e1509) + (_e1518 * _e1521)) + ((_e1531 * _e1534) + (_e1543 * _e1546))));
                        if (_e970 > _e1043) {
                            phi_2559_ = _e970;
                        } else {
                            phi_2559_ = _e1043;
                        }
                        let _e1557 = phi_2559_;
                        if (_e1557 > _e1116) {
                            phi_2564_ = _e1557;
                        } else {
                            phi_2564_ = _e1116;
                        }
                        let _e1560 = phi_2564_;
                        if (_e1189 > _e1262) {
                            phi_2569_ = _e1189;
                        } else {
                            phi_2569_ = _e1262;
                        }
                        let _e1563 = phi_2569_;
                        if (_e1563 > _e1335) {
                            phi_2574_ = _e1563;
                        } else {
                            phi_2574_ = _e1335;
                        }
                        let _e1566 = phi_2574_;
                        if (_e1560 > _e1566) {
                            phi_2579_ = _e1560;
                        } else {
                            phi_2579_ = _e1566;
                        }
                        let _e1569 = phi_2579_;
                        if (_e1408 > _e1481) {
                            phi_2584_ = _e1408;
                        } else {
                            phi_2584_ = _e1481;
                        }
                        let _e1572 = phi_2584_;
                        if (_e1572 > _e1554) {
                            phi_2589_ = _e1572;
                        } else {
                            phi_2589_ = _e1554;
                        }
                        let _e1575 = phi_2589_;
                        if (_e1569 > _e1575) {
                            phi_2594_ = _e1569;
                        } else {
                            phi_2594_ = _e1575;
                        }
                        let _e1578 = phi_2594_;
                        let _e1580 = local.member_5;
                        phi_2598_ = (_e1578 > _e1580);
                    }
                    let _e1583 = phi_2598_;
                    phi_2600_ = !(_e1583);
                    phi_2601_ = false;
                } else {
                    phi_2600_ = bool();
                    phi_2601_ = true;
                }
                let _e1586 = phi_2600_;
                let _e1588 = phi_2601_;
                phi_2602_ = _e1586;
                phi_2603_ = _e1588;
            }
            let _e1590 = phi_2602_;
            let _e1592 = phi_2603_;
            if _e1592 {
                phi_2607_ = true;
            } else {
                phi_2607_ = _e1590;
            }
            let _e1594 = phi_2607_;
            if _e1594 {
                let _e1597 = params.member.member_2.member;
                if (_e1597 == 0u) {
                    phi_2621_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_2621_ = array<u32, 2>(1u, 1u);
                }
                let _e1600 = phi_2621_;
                let _e1606 = params.member.member.member[_e1600[0]];
                let _e1611 = params.member.member.member[_e1600[1]];
                if (_e83[0] == 4294967295u) {
                    phi_2663_ = 0u;
                } else {
                    if (_e83[0] >= (_e1606 - 1u)) {
                        if (_e83[1] >= (_e1611 - 1u)) {
                            phi_2657_ = false;
                        } else {
                            phi_2657_ = true;
                        }
                        let _e1620 = phi_2657_;
                        phi_2658_ = _e1620;
                    } else {
                        phi_2658_ = true;
                    }
                    let _e1622 = phi_2658_;
                    if _e1622 {
                        phi_2662_ = 1u;
                    } else {
                        phi_2662_ = 2u;
                    }
                    let _e1624 = phi_2662_;
                    phi_2663_ = _e1624;
                }
                let _e1626 = phi_2663_;
                phi_2664_ = _e1626;
            } else {
                phi_2664_ = 3u;
            }
            let _e1628 = phi_2664_;
            phi_2665_ = _e1628;
        } else {
            phi_2665_ = 3u;
        }
        let _e1630 = phi_2665_;
        phi_2666_ = _e1630;
    } else {
        phi_2666_ = 0u;
    }
    let _e1632 = phi_2666_;
    if (_e1632 == 1u) {
        let _e1642 = atomicAdd((&shared_[6u]), 1u);
        phi_2685_ = array<u32, 2>(_e1642, 0u);
    } else {
        if (_e1632 == 2u) {
            let _e1637 = atomicAdd((&shared_[7u]), 1u);
            phi_2684_ = array<u32, 2>(_e1637, 0u);
        } else {
            phi_2684_ = array<u32, 2>(0u, 0u);
        }
        let _e1640 = phi_2684_;
        phi_2685_ = _e1640;
    }
    let _e1645 = phi_2685_;
    if (_e1632 >= 2u) {
        if (_e65.member_4 > 0u) {
            let _e1649 = atomicAdd((&shared_[8u]), 1u);
            phi_2697_ = array<u32, 2>(_e1645[0], _e1649);
        } else {
            phi_2697_ = _e1645;
        }
        let _e1653 = phi_2697_;
        phi_2698_ = _e1653;
    } else {
        phi_2698_ = _e1645;
    }
    let _e1655 = phi_2698_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e1658 = atomicLoad((&shared_[6u]));
        let _e1660 = atomicLoad((&shared_[7u]));
        if (_e1658 > 0u) {
            let _e1663 = atomicAdd((&control.member[0u]), _e1658);
            let _e1666 = atomicMax((&nodes.member[0u]), (_e1663 + _e1658));
            if ((_e1663 + _e1658) < _e1663) {
                let _e1670 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e1663);
        }
        if (_e1660 > 0u) {
            let _e1674 = atomicAdd((&pairs.member[0u]), _e1660);
            if ((_e1674 + _e1660) < _e1674) {
                let _e1678 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e1674);
        }
        let _e1681 = atomicLoad((&shared_[8u]));
        if (_e1681 > 0u) {
            let _e1684 = atomicLoad((&shared_[8u]));
            let _e1686 = atomicAdd((&control.member[1537u]), _e1684);
            if ((_e1686 + _e1684) < _e1686) {
                let _e1690 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e1686);
        }
    }
    workgroupBarrier();
    if (_e1632 == 1u) {
        let _e1749 = atomicLoad((&shared_[11u]));
        let _e1751 = (_e1749 + _e1655[0]);
        if (_e1751 < _e65.member_3) {
            if (_e1751 < 4294967295u) {
                let _e1757 = (2u * _e1751);
                atomicStore((&nodes.member[(4u + _e1757)]), _e83[0]);
                atomicStore((&nodes.member[(_e1757 + 5u)]), _e83[1]);
            }
        }
    } else {
        if (_e1632 == 0u) {
        } else {
            if (_e1632 == 2u) {
                let _e1697 = a.member[_e83[0]];
                let _e1701 = b.member[_e83[1]];
                let _e1705 = params.member.member_2.member;
                if (_e1705 == 1u) {
                    if (_e1697.member_1 < _e1701.member_1) {
                        phi_2856_ = type_9(_e1697.member_1, _e1701.member_1);
                    } else {
                        phi_2856_ = type_9(_e1701.member_1, _e1697.member_1);
                    }
                    let _e1712 = phi_2856_;
                    phi_2861_ = _e1712;
                } else {
                    phi_2861_ = type_9(_e1697.member_1, _e1701.member_1);
                }
                let _e1714 = phi_2861_;
                let _e1718 = params.member.member_1;
                let _e1721 = atomicLoad((&shared_[12u]));
                let _e1723 = (_e1721 + _e1655[0]);
                if (_e1723 < _e1718.member_3) {
                    let _e1725 = (2u * _e1723);
                    atomicStore((&pairs.member[(4u + _e1725)]), _e1714.member);
                    atomicStore((&pairs.member[(_e1725 + 5u)]), _e1714.member_1);
                }
            }
            if (_e65.member_4 > 0u) {
                let _e1733 = atomicLoad((&shared_[13u]));
                let _e1735 = (_e1733 + _e1655[1]);
                if (_e1735 < _e65.member_4) {
                    let _e1742 = (2u * ((_e65.member_5 * _e65.member_4) + _e1735));
                    front.member[_e1742] = _e83[0];
                    front.member[(_e1742 + 1u)] = _e83[1];
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn resume_front_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
