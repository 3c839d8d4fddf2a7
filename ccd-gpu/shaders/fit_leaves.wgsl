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

struct type_13 {
    member: i32,
    member_1: i32,
}

struct type_14 {
    member: u32,
    member_1: i32,
}

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_19 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: array<vec4<u32>>,
}

struct type_26 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_33 {
    member: array<array<u32, 3>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> order: type_10;
@group(0) @binding(1) 
var<storage> boxes: type_28;
var<workgroup> shared_: array<type_30, 256>;
@group(0) @binding(3) 
var<storage> edges: type_21;
@group(0) @binding(4) 
var<storage> faces: type_33;
@group(0) @binding(5) 
var<storage> bodies: type_10;
@group(0) @binding(6) 
var<storage, read_write> nodes: type_28;
@group(0) @binding(7) 
var<storage, read_write> leaves: type_24;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_141_: u32;
    var phi_142_: u32;
    var phi_265_: type_19;
    var phi_266_: type_19;
    var phi_267_: type_19;
    var phi_268_: type_19;
    var phi_269_: type_30;
    var phi_270_: type_19;
    var phi_271_: type_30;
    var phi_318_: bool;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_337_: f32;
    var phi_339_: type_30;
    var phi_340_: type_30;
    var phi_341_: type_30;
    var phi_356_: type_13;
    var phi_359_: type_30;
    var phi_361_: u32;
    var phi_382_: bool;
    var phi_388_: type_14;
    var phi_357_: type_13;
    var phi_402_: type_14;
    var phi_554_: f32;
    var phi_561_: f32;
    var phi_568_: f32;
    var phi_576_: f32;
    var phi_583_: f32;
    var phi_590_: f32;
    var phi_437_: f32;
    var phi_444_: f32;
    var phi_451_: f32;
    var phi_459_: f32;
    var phi_466_: f32;
    var phi_473_: f32;
    var phi_487_: bool;
    var phi_502_: bool;
    var phi_503_: bool;
    var phi_525_: bool;
    var phi_542_: f32;
    var phi_543_: f32;
    var phi_544_: f32;
    var phi_546_: type_30;
    var phi_547_: type_30;
    var phi_593_: type_30;
    var phi_606_: type_30;
    var phi_360_: type_30;
    var phi_362_: u32;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var local_5: type_30;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e50 = ((((_e33.y * _e34.x) + _e33.x) * 256u) + _e35);
    let _e55 = params.member.member_2.member[0u][2u];
    if (_e50 >= _e55) {
        phi_142_ = 2u;
    } else {
        let _e58 = params.member.member_2.member[0u][1u];
        if (_e50 >= _e58) {
            phi_141_ = 1u;
        } else {
            phi_141_ = 0u;
        }
        let _e61 = phi_141_;
        phi_142_ = _e61;
    }
    let _e63 = phi_142_;
    let _e68 = params.member.member_2.member[0u][_e63];
    let _e69 = (_e50 - _e68);
    let _e74 = params.member.member_2.member[0u][3u];
    let _e75 = (_e50 < _e74);
    if _e75 {
        let _e79 = params.member.member.member[_e63];
        if (_e69 < _e79) {
            let _e84 = params.member.member.member_2[_e63];
            let _e87 = order.member[(_e84 + _e69)];
            let _e89 = boxes.member[_e87];
            let _e108 = params.member.member.member_2[_e63];
            let _e109 = (_e87 - _e108);
            let _e113 = type_19(array<u32, 3>(_e109, _e109, _e109), type_19(array<u32, 3>(0u, 0u, 0u), _e109).member_1);
            let _e116 = params.member.member.member_1;
            if ((_e116 & 1u) != 0u) {
                if (_e63 == 1u) {
                    let _e128 = edges.member[_e109];
                    phi_266_ = type_19(array<u32, 3>(_e128[0], _e128[1], _e128[1]), _e113.member_1);
                } else {
                    if (_e63 == 2u) {
                        let _e122 = faces.member[_e109];
                        phi_265_ = type_19(_e122, _e113.member_1);
                    } else {
                        phi_265_ = _e113;
                    }
                    let _e126 = phi_265_;
                    phi_266_ = _e126;
                }
                let _e136 = phi_266_;
                phi_267_ = _e136;
            } else {
                phi_267_ = _e113;
            }
            let _e138 = phi_267_;
            phi_268_ = _e138;
            phi_269_ = type_30(array<f32, 3>(_e89.member.x, _e89.member.y, _e89.member_1.x), array<f32, 3>(_e89.member_1.y, _e89.member_2.x, _e89.member_2.y));
        } else {
            phi_268_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
            phi_269_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e140 = phi_268_;
        let _e142 = phi_269_;
        phi_270_ = _e140;
        phi_271_ = _e142;
    } else {
        phi_270_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        phi_271_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e144 = phi_270_;
    let _e146 = phi_271_;
    let _e149 = params.member.member.member_1;
    let _e151 = ((_e149 & 256u) != 0u);
    if _e151 {
        let _e155 = bodies.member[_e144.member[0]];
        if (_e146.member[0] <= _e146.member_1[0]) {
            if (((bitcast<u32>(_e146.member_1[0]) & 1u) == 1u) != ((_e155 & 1u) == 1u)) {
                let _e171 = bitcast<u32>(_e146.member_1[0]);
                if ((_e171 & 2139095040u) == 2139095040u) {
                    phi_318_ = (_e146.member_1[0] < 0f);
                } else {
                    phi_318_ = true;
                }
                let _e176 = phi_318_;
                if _e176 {
                    if (_e146.member_1[0] > 0f) {
                        phi_336_ = bitcast<f32>((_e171 + 1u));
                    } else {
                        if (_e146.member_1[0] < 0f) {
                            phi_335_ = bitcast<f32>((_e171 - 1u));
                        } else {
                            phi_335_ = 0.000000000000000000000000000000000000000000001f;
                        }
                        let _e182 = phi_335_;
                        phi_336_ = _e182;
                    }
                    let _e186 = phi_336_;
                    phi_337_ = _e186;
                } else {
                    phi_337_ = _e146.member_1[0];
                }
                let _e188 = phi_337_;
                phi_339_ = type_30(_e146.member, array<f32, 3>(_e188, _e146.member_1[1], _e146.member_1[2]));
            } else {
                phi_339_ = _e146;
            }
            let _e196 = phi_339_;
            phi_340_ = _e196;
        } else {
            phi_340_ = _e146;
        }
        let _e198 = phi_340_;
        phi_341_ = _e198;
    } else {
        phi_341_ = _e146;
    }
    let _e200 = phi_341_;
    shared_[_e35] = type_30(array<f32, 3>(_e200.member[0], _e200.member[1], _e200.member[2]), array<f32, 3>(_e200.member_1[0], _e200.member_1[1], _e200.member_1[2]));
    phi_356_ = type_13(0i, 5i);
    phi_359_ = _e200;
    phi_361_ = 16u;
    loop {
        let _e214 = phi_356_;
        let _e216 = phi_359_;
        let _e218 = phi_361_;
        local = _e216;
        local_1 = _e216;
        local_2 = _e216;
        local_3 = _e216;
        local_4 = _e216;
        local_5 = _e216;
        if (_e214.member < _e214.member_1) {
            let _e225 = (_e214.member + 1i);
            if ((false == (_e225 > _e214.member)) != false) {
                phi_382_ = true;
            } else {
                phi_382_ = false;
            }
            let _e230 = phi_382_;
            if _e230 {
                phi_388_ = type_14(0u, type_14().member_1);
            } else {
                phi_388_ = type_14(1u, _e225);
            }
            let _e235 = phi_388_;
            phi_357_ = type_13(_e235.member_1, _e214.member_1);
            phi_402_ = type_14(1u, _e214.member);
        } else {
            phi_357_ = _e214;
            phi_402_ = type_14(0u, type_14().member_1);
        }
        let _e241 = phi_357_;
        let _e243 = phi_402_;
        let _e246 = (bitcast<i32>(_e243.member) != 0i);
        if _e246 {
            workgroupBarrier();
            if ((_e35 % 32u) < _e218) {
                let _e251 = shared_[(_e35 + _e218)];
                if _e151 {
                    if (_e216.member[0] < _e251.member[0]) {
                        phi_437_ = _e216.member[0];
                    } else {
                        phi_437_ = _e251.member[0];
                    }
                    let _e297 = phi_437_;
                    if (_e216.member[1] < _e251.member[1]) {
                        phi_444_ = _e216.member[1];
                    } else {
                        phi_444_ = _e251.member[1];
                    }
                    let _e302 = phi_444_;
                    if (_e216.member[2] < _e251.member[2]) {
                        phi_451_ = _e216.member[2];
                    } else {
                        phi_451_ = _e251.member[2];
                    }
                    let _e307 = phi_451_;
                    if (_e216.member_1[0] > _e251.member_1[0]) {
                        phi_459_ = _e216.member_1[0];
                    } else {
                        phi_459_ = _e251.member_1[0];
                    }
                    let _e313 = phi_459_;
                    if (_e216.member_1[1] > _e251.member_1[1]) {
                        phi_466_ = _e216.member_1[1];
                    } else {
                        phi_466_ = _e251.member_1[1];
                    }
                    let _e318 = phi_466_;
                    if (_e216.member_1[2] > _e251.member_1[2]) {
                        phi_473_ = _e216.member_1[2];
                    } else {
                        phi_473_ = _e251.member_1[2];
                    }
                    let _e323 = phi_473_;
                    let _e325 = type_30(array<f32, 3>(_e297, _e302, _e307), array<f32, 3>(_e313, _e318, _e323));
                    if ((bitcast<u32>(_e216.member_1[0]) & 1u) == 1u) {
                        phi_487_ = true;
                    } else {
                        phi_487_ = !((_e216.member[0] <= _e216.member_1[0]));
                    }
                    let _e338 = phi_487_;
                    if _e338 {
                        if ((bitcast<u32>(_e251.member_1[0]) & 1u) == 1u) {
                            phi_502_ = true;
                        } else {
                            phi_502_ = !((_e251.member[0] <= _e251.member_1[0]));
                        }
                        let _e345 = phi_502_;
                        phi_503_ = _e345;
                    } else {
                        phi_503_ = false;
                    }
                    let _e347 = phi_503_;
                    if (_e297 <= _e313) {
                        if (((bitcast<u32>(_e313) & 1u) == 1u) != _e347) {
                            let _e353 = bitcast<u32>(_e313);
                            if ((_e353 & 2139095040u) == 2139095040u) {
                                phi_525_ = (_e313 < 0f);
                            } else {
                                phi_525_ = true;
                            }
                            let _e358 = phi_525_;
                            if _e358 {
                                if (_e313 > 0f) {
                                    phi_543_ = bitcast<f32>((_e353 + 1u));
                                } else {
                                    if (_e313 < 0f) {
                                        phi_542_ = bitcast<f32>((_e353 - 1u));
                                    } else {
                                        phi_542_ = 0.000000000000000000000000000000000000000000001f;
                                    }
                                    let _e364 = phi_542_;
                                    phi_543_ = _e364;
                                }
                                let _e368 = phi_543_;
                                phi_544_ = _e368;
                            } else {
                                phi_544_ = _e313;
                            }
                            let _e370 = phi_544_;
                            phi_546_ = type_30(_e325.member, array<f32, 3>(_e370, _e325.member_1[1], _e325.member_1[2]));
                        } else {
                            phi_546_ = _e325;
                        }
                        let _e378 = phi_546_;
                        phi_547_ = _e378;
                    } else {
                        phi_547_ = _e325;
                    }
                    let _e380 = phi_547_;
                    phi_593_ = _e380;
                } else {
                    if (_e216.member[0] < _e251.member[0]) {
                        phi_554_ = _e216.member[0];
                    } else {
                        phi_554_ = _e251.member[0];
                    }
                    let _e264 = phi_554_;
                    if (_e216.member[1] < _e251.member[1]) {
                        phi_561_ = _e216.member[1];
                    } else {
                        phi_561_ = _e251.member[1];
                    }
                    let _e269 = phi_561_;
                    if (_e216.member[2] < _e251.member[2]) {
                        phi_568_ = _e216.member[2];
                    } else {
                        phi_568_ = _e251.member[2];
                    }
                    let _e274 = phi_568_;
                    if (_e216.member_1[0] > _e251.member_1[0]) {
                        phi_576_ = _e216.member_1[0];
                    } else {
                        phi_576_ = _e251.member_1[0];
                    }
                    let _e280 = phi_576_;
                    if (_e216.member_1[1] > _e251.member_1[1]) {
                        phi_583_ = _e216.member_1[1];
                    } else {
                        phi_583_ = _e251.member_1[1];
                    }
                    let _e285 = phi_583_;
                    if (_e216.member_1[2] > _e251.member_1[2]) {
                        phi_590_ = _e216.member_1[2];
                    } else {
                        phi_590_ = _e251.member_1[2];
                    }
                    let _e290 = phi_590_;
                    phi_593_ = type_30(array<f32, 3>(_e264, _e269, _e274), array<f32, 3>(_e280, _e285, _e290));
                }
                let _e382 = phi_593_;
                shared_[_e35] = type_30(array<f32, 3>(_e382.member[0], _e382.member[1], _e382.member[2]), array<f32, 3>(_e382.member_1[0], _e382.member_1[1], _e382.member_1[2]));
                phi_606_ = _e382;
            } else {
                phi_606_ = _e216;
            }
            let _e396 = phi_606_;
            phi_360_ = _e396;
            phi_362_ = (_e218 / 2u);
        } else {
            phi_360_ = type_30();
            phi_362_ = u32();
        }
        let _e399 = phi_360_;
        let _e401 = phi_362_;
        continue;
        continuing {
            phi_356_ = _e241;
            phi_359_ = _e399;
            phi_361_ = _e401;
            break if !(_e246);
        }
    }
    if _e75 {
        nodes.member[_e50] = type_26(vec2<f32>(_e146.member[0], _e146.member[1]), vec2<f32>(_e146.member[2], _e146.member_1[0]), vec2<f32>(_e146.member_1[1], _e146.member_1[2]));
        leaves.member[_e50] = vec4<u32>(_e144.member[0], _e144.member[1], _e144.member[2], _e144.member_1);
        if ((_e35 % 32u) == 0u) {
            let _e436 = params.member.member_2.member[1u][_e63];
            let _e439 = local;
            let _e443 = local_1;
            let _e447 = local_2;
            let _e451 = local_3;
            let _e455 = local_4;
            let _e459 = local_5;
            nodes.member[(_e436 + (_e69 / 32u))] = type_26(vec2<f32>(_e439.member[0], _e443.member[1]), vec2<f32>(_e447.member[2], _e451.member_1[0]), vec2<f32>(_e455.member_1[1], _e459.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
