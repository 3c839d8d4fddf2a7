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
    var phi_142_: u32;
    var phi_143_: u32;
    var phi_266_: type_19;
    var phi_267_: type_19;
    var phi_268_: type_19;
    var phi_269_: type_19;
    var phi_270_: type_30;
    var phi_271_: type_19;
    var phi_272_: type_30;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_334_: u32;
    var phi_335_: u32;
    var phi_336_: bool;
    var phi_337_: u32;
    var phi_338_: bool;
    var phi_345_: u32;
    var phi_348_: type_30;
    var phi_349_: type_30;
    var phi_350_: type_30;
    var phi_365_: type_13;
    var phi_368_: type_30;
    var phi_370_: u32;
    var phi_391_: bool;
    var phi_397_: type_14;
    var phi_366_: type_13;
    var phi_411_: type_14;
    var phi_571_: f32;
    var phi_578_: f32;
    var phi_585_: f32;
    var phi_593_: f32;
    var phi_600_: f32;
    var phi_607_: f32;
    var phi_446_: f32;
    var phi_453_: f32;
    var phi_460_: f32;
    var phi_468_: f32;
    var phi_475_: f32;
    var phi_482_: f32;
    var phi_496_: bool;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_549_: u32;
    var phi_550_: u32;
    var phi_551_: bool;
    var phi_552_: u32;
    var phi_553_: bool;
    var phi_560_: u32;
    var phi_563_: type_30;
    var phi_564_: type_30;
    var phi_610_: type_30;
    var phi_623_: type_30;
    var phi_369_: type_30;
    var phi_371_: u32;
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
        phi_143_ = 2u;
    } else {
        let _e58 = params.member.member_2.member[0u][1u];
        if (_e50 >= _e58) {
            phi_142_ = 1u;
        } else {
            phi_142_ = 0u;
        }
        let _e61 = phi_142_;
        phi_143_ = _e61;
    }
    let _e63 = phi_143_;
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
                    phi_267_ = type_19(array<u32, 3>(_e128[0], _e128[1], _e128[1]), _e113.member_1);
                } else {
                    if (_e63 == 2u) {
                        let _e122 = faces.member[_e109];
                        phi_266_ = type_19(_e122, _e113.member_1);
                    } else {
                        phi_266_ = _e113;
                    }
                    let _e126 = phi_266_;
                    phi_267_ = _e126;
                }
                let _e136 = phi_267_;
                phi_268_ = _e136;
            } else {
                phi_268_ = _e113;
            }
            let _e138 = phi_268_;
            phi_269_ = _e138;
            phi_270_ = type_30(array<f32, 3>(_e89.member.x, _e89.member.y, _e89.member_1.x), array<f32, 3>(_e89.member_1.y, _e89.member_2.x, _e89.member_2.y));
        } else {
            phi_269_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
            phi_270_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e140 = phi_269_;
        let _e142 = phi_270_;
        phi_271_ = _e140;
        phi_272_ = _e142;
    } else {
        phi_271_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        phi_272_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e144 = phi_271_;
    let _e146 = phi_272_;
    let _e149 = params.member.member.member_1;
    let _e151 = ((_e149 & 256u) != 0u);
    if _e151 {
        let _e155 = bodies.member[_e144.member[0]];
        if (_e146.member[0] <= _e146.member_1[0]) {
            if (((bitcast<u32>(_e146.member_1[0]) & 1u) == 1u) != ((_e155 & 1u) == 1u)) {
                let _e171 = bitcast<u32>(_e146.member_1[0]);
                let _e174 = ((_e171 >> bitcast<u32>(31i)) == 1u);
                let _e175 = (_e171 & 2147483647u);
                if (_e175 < 8388608u) {
                    phi_337_ = u32();
                    phi_338_ = true;
                } else {
                    if _e174 {
                        if (_e175 == 8388608u) {
                            phi_324_ = false;
                        } else {
                            phi_324_ = true;
                        }
                        let _e179 = phi_324_;
                        phi_325_ = _e179;
                    } else {
                        phi_325_ = true;
                    }
                    let _e181 = phi_325_;
                    if _e181 {
                        if _e174 {
                            phi_334_ = (_e171 - 1u);
                        } else {
                            phi_334_ = (_e171 + 1u);
                        }
                        let _e185 = phi_334_;
                        phi_335_ = _e185;
                        phi_336_ = false;
                    } else {
                        phi_335_ = u32();
                        phi_336_ = true;
                    }
                    let _e187 = phi_335_;
                    let _e189 = phi_336_;
                    phi_337_ = _e187;
                    phi_338_ = _e189;
                }
                let _e191 = phi_337_;
                let _e193 = phi_338_;
                if _e193 {
                    phi_345_ = (8388608u | ((_e171 & 1u) ^ 1u));
                } else {
                    phi_345_ = _e191;
                }
                let _e198 = phi_345_;
                phi_348_ = type_30(_e146.member, array<f32, 3>(bitcast<f32>(_e198), _e146.member_1[1], _e146.member_1[2]));
            } else {
                phi_348_ = _e146;
            }
            let _e207 = phi_348_;
            phi_349_ = _e207;
        } else {
            phi_349_ = _e146;
        }
        let _e209 = phi_349_;
        phi_350_ = _e209;
    } else {
        phi_350_ = _e146;
    }
    let _e211 = phi_350_;
    shared_[_e35] = type_30(array<f32, 3>(_e211.member[0], _e211.member[1], _e211.member[2]), array<f32, 3>(_e211.member_1[0], _e211.member_1[1], _e211.member_1[2]));
    phi_365_ = type_13(0i, 5i);
    phi_368_ = _e211;
    phi_370_ = 16u;
    loop {
        let _e225 = phi_365_;
        let _e227 = phi_368_;
        let _e229 = phi_370_;
        local = _e227;
        local_1 = _e227;
        local_2 = _e227;
        local_3 = _e227;
        local_4 = _e227;
        local_5 = _e227;
        if (_e225.member < _e225.member_1) {
            let _e236 = (_e225.member + 1i);
            if ((false == (_e236 > _e225.member)) != false) {
                phi_391_ = true;
            } else {
                phi_391_ = false;
            }
            let _e241 = phi_391_;
            if _e241 {
                phi_397_ = type_14(0u, type_14().member_1);
            } else {
                phi_397_ = type_14(1u, _e236);
            }
            let _e246 = phi_397_;
            phi_366_ = type_13(_e246.member_1, _e225.member_1);
            phi_411_ = type_14(1u, _e225.member);
        } else {
            phi_366_ = _e225;
            phi_411_ = type_14(0u, type_14().member_1);
        }
        let _e252 = phi_366_;
        let _e254 = phi_411_;
        let _e257 = (bitcast<i32>(_e254.member) != 0i);
        if _e257 {
            workgroupBarrier();
            if ((_e35 % 32u) < _e229) {
                let _e262 = shared_[(_e35 + _e229)];
                if _e151 {
                    if (_e227.member[0] < _e262.member[0]) {
                        phi_446_ = _e227.member[0];
                    } else {
                        phi_446_ = _e262.member[0];
                    }
                    let _e308 = phi_446_;
                    if (_e227.member[1] < _e262.member[1]) {
                        phi_453_ = _e227.member[1];
                    } else {
                        phi_453_ = _e262.member[1];
                    }
                    let _e313 = phi_453_;
                    if (_e227.member[2] < _e262.member[2]) {
                        phi_460_ = _e227.member[2];
                    } else {
                        phi_460_ = _e262.member[2];
                    }
                    let _e318 = phi_460_;
                    if (_e227.member_1[0] > _e262.member_1[0]) {
                        phi_468_ = _e227.member_1[0];
                    } else {
                        phi_468_ = _e262.member_1[0];
                    }
                    let _e324 = phi_468_;
                    if (_e227.member_1[1] > _e262.member_1[1]) {
                        phi_475_ = _e227.member_1[1];
                    } else {
                        phi_475_ = _e262.member_1[1];
                    }
                    let _e329 = phi_475_;
                    if (_e227.member_1[2] > _e262.member_1[2]) {
                        phi_482_ = _e227.member_1[2];
                    } else {
                        phi_482_ = _e262.member_1[2];
                    }
                    let _e334 = phi_482_;
                    let _e336 = type_30(array<f32, 3>(_e308, _e313, _e318), array<f32, 3>(_e324, _e329, _e334));
                    if ((bitcast<u32>(_e227.member_1[0]) & 1u) == 1u) {
                        phi_496_ = true;
                    } else {
                        phi_496_ = !((_e227.member[0] <= _e227.member_1[0]));
                    }
                    let _e349 = phi_496_;
                    if _e349 {
                        if ((bitcast<u32>(_e262.member_1[0]) & 1u) == 1u) {
                            phi_511_ = true;
                        } else {
                            phi_511_ = !((_e262.member[0] <= _e262.member_1[0]));
                        }
                        let _e356 = phi_511_;
                        phi_512_ = _e356;
                    } else {
                        phi_512_ = false;
                    }
                    let _e358 = phi_512_;
                    if (_e308 <= _e324) {
                        if (((bitcast<u32>(_e324) & 1u) == 1u) != _e358) {
                            let _e364 = bitcast<u32>(_e324);
                            let _e367 = ((_e364 >> bitcast<u32>(31i)) == 1u);
                            let _e368 = (_e364 & 2147483647u);
                            if (_e368 < 8388608u) {
                                phi_552_ = u32();
                                phi_553_ = true;
                            } else {
                                if _e367 {
                                    if (_e368 == 8388608u) {
                                        phi_539_ = false;
                                    } else {
                                        phi_539_ = true;
                                    }
                                    let _e372 = phi_539_;
                                    phi_540_ = _e372;
                                } else {
                                    phi_540_ = true;
                                }
                                let _e374 = phi_540_;
                                if _e374 {
                                    if _e367 {
                                        phi_549_ = (_e364 - 1u);
                                    } else {
                                        phi_549_ = (_e364 + 1u);
                                    }
                                    let _e378 = phi_549_;
                                    phi_550_ = _e378;
                                    phi_551_ = false;
                                } else {
                                    phi_550_ = u32();
                                    phi_551_ = true;
                                }
                                let _e380 = phi_550_;
                                let _e382 = phi_551_;
                                phi_552_ = _e380;
                                phi_553_ = _e382;
                            }
                            let _e384 = phi_552_;
                            let _e386 = phi_553_;
                            if _e386 {
                                phi_560_ = (8388608u | ((_e364 & 1u) ^ 1u));
                            } else {
                                phi_560_ = _e384;
                            }
                            let _e391 = phi_560_;
                            phi_563_ = type_30(_e336.member, array<f32, 3>(bitcast<f32>(_e391), _e336.member_1[1], _e336.member_1[2]));
                        } else {
                            phi_563_ = _e336;
                        }
                        let _e400 = phi_563_;
                        phi_564_ = _e400;
                    } else {
                        phi_564_ = _e336;
                    }
                    let _e402 = phi_564_;
                    phi_610_ = _e402;
                } else {
                    if (_e227.member[0] < _e262.member[0]) {
                        phi_571_ = _e227.member[0];
                    } else {
                        phi_571_ = _e262.member[0];
                    }
                    let _e275 = phi_571_;
                    if (_e227.member[1] < _e262.member[1]) {
                        phi_578_ = _e227.member[1];
                    } else {
                        phi_578_ = _e262.member[1];
                    }
                    let _e280 = phi_578_;
                    if (_e227.member[2] < _e262.member[2]) {
                        phi_585_ = _e227.member[2];
                    } else {
                        phi_585_ = _e262.member[2];
                    }
                    let _e285 = phi_585_;
                    if (_e227.member_1[0] > _e262.member_1[0]) {
                        phi_593_ = _e227.member_1[0];
                    } else {
                        phi_593_ = _e262.member_1[0];
                    }
                    let _e291 = phi_593_;
                    if (_e227.member_1[1] > _e262.member_1[1]) {
                        phi_600_ = _e227.member_1[1];
                    } else {
                        phi_600_ = _e262.member_1[1];
                    }
                    let _e296 = phi_600_;
                    if (_e227.member_1[2] > _e262.member_1[2]) {
                        phi_607_ = _e227.member_1[2];
                    } else {
                        phi_607_ = _e262.member_1[2];
                    }
                    let _e301 = phi_607_;
                    phi_610_ = type_30(array<f32, 3>(_e275, _e280, _e285), array<f32, 3>(_e291, _e296, _e301));
                }
                let _e404 = phi_610_;
                shared_[_e35] = type_30(array<f32, 3>(_e404.member[0], _e404.member[1], _e404.member[2]), array<f32, 3>(_e404.member_1[0], _e404.member_1[1], _e404.member_1[2]));
                phi_623_ = _e404;
            } else {
                phi_623_ = _e227;
            }
            let _e418 = phi_623_;
            phi_369_ = _e418;
            phi_371_ = (_e229 / 2u);
        } else {
            phi_369_ = type_30();
            phi_371_ = u32();
        }
        let _e421 = phi_369_;
        let _e423 = phi_371_;
        continue;
        continuing {
            phi_365_ = _e252;
            phi_368_ = _e421;
            phi_370_ = _e423;
            break if !(_e257);
        }
    }
    if _e75 {
        nodes.member[_e50] = type_26(vec2<f32>(_e146.member[0], _e146.member[1]), vec2<f32>(_e146.member[2], _e146.member_1[0]), vec2<f32>(_e146.member_1[1], _e146.member_1[2]));
        leaves.member[_e50] = vec4<u32>(_e144.member[0], _e144.member[1], _e144.member[2], _e144.member_1);
        if ((_e35 % 32u) == 0u) {
            let _e458 = params.member.member_2.member[1u][_e63];
            let _e461 = local;
            let _e465 = local_1;
            let _e469 = local_2;
            let _e473 = local_3;
            let _e477 = local_4;
            let _e481 = local_5;
            nodes.member[(_e458 + (_e69 / 32u))] = type_26(vec2<f32>(_e461.member[0], _e465.member[1]), vec2<f32>(_e469.member[2], _e473.member_1[0]), vec2<f32>(_e477.member_1[1], _e481.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
