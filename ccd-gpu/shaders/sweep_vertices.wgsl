struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_10 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
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
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
}

struct type_16 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_20 {
    member: array<type_18>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_13;
@group(0) @binding(1) 
var<storage> paths: type_20;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var local_2: type_4;
    var local_3: type_4;
    var local_4: type_4;
    var phi_141_: type_16;
    var phi_142_: type_16;
    var phi_165_: type_16;
    var phi_191_: f32;
    var phi_218_: f32;
    var phi_255_: type_16;
    var phi_256_: type_16;
    var phi_279_: type_16;
    var phi_306_: bool;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_352_: bool;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_415_: type_16;
    var phi_416_: type_16;
    var phi_439_: type_16;
    var phi_469_: bool;
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_488_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_530_: bool;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_549_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_561_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e35 = ((((_e23.y * _e24.x) + _e23.x) * 256u) + _e25);
    let _e38 = params.member.member[0u];
    if (_e35 < _e38) {
        let _e41 = paths.member[_e35];
        let _e43 = params.member.member_3;
        local_3 = type_4(array<f32, 3>(_e41.member_1[0], _e41.member_1[1], _e41.member_1[2]), array<f32, 3>(_e41.member_1[0], _e41.member_1[1], _e41.member_1[2]));
        local_2 = type_4(array<f32, 3>(_e41.member[0], _e41.member[1], _e41.member[2]), array<f32, 3>(_e41.member[0], _e41.member[1], _e41.member[2]));
        phi_141_ = type_16(0u, 3u);
        loop {
            let _e59 = phi_141_;
            if (_e59.member < _e59.member_1) {
                phi_142_ = type_16((_e59.member + 1u), _e59.member_1);
                phi_165_ = type_16(1u, _e59.member);
            } else {
                phi_142_ = _e59;
                phi_165_ = type_16(0u, type_16().member_1);
            }
            let _e71 = phi_142_;
            let _e73 = phi_165_;
            let _e77 = (bitcast<i32>(_e73.member) != 0i);
            if _e77 {
                let _e80 = local_2.member[_e73.member_1];
                let _e83 = local_3.member[_e73.member_1];
                if (_e80 < _e83) {
                    phi_191_ = _e80;
                } else {
                    phi_191_ = _e83;
                }
                let _e86 = phi_191_;
                local_2.member[_e73.member_1] = _e86;
                let _e91 = local_2.member_1[_e73.member_1];
                let _e94 = local_3.member_1[_e73.member_1];
                if (_e91 > _e94) {
                    phi_218_ = _e91;
                } else {
                    phi_218_ = _e94;
                }
                let _e97 = phi_218_;
                local_2.member_1[_e73.member_1] = _e97;
            }
            continue;
            continuing {
                phi_141_ = _e71;
                break if !(_e77);
            }
        }
        let _e101 = local_2;
        if (_e43 > 0f) {
            local_1 = _e101;
            phi_255_ = type_16(0u, 3u);
            loop {
                let _e104 = phi_255_;
                if (_e104.member < _e104.member_1) {
                    phi_256_ = type_16((_e104.member + 1u), _e104.member_1);
                    phi_279_ = type_16(1u, _e104.member);
                } else {
                    phi_256_ = _e104;
                    phi_279_ = type_16(0u, type_16().member_1);
                }
                let _e116 = phi_256_;
                let _e118 = phi_279_;
                let _e122 = (bitcast<i32>(_e118.member) != 0i);
                if _e122 {
                    let _e125 = local_1.member[_e118.member_1];
                    let _e127 = -((_e125 - _e43));
                    let _e128 = bitcast<u32>(_e127);
                    if ((_e128 & 2139095040u) == 2139095040u) {
                        phi_306_ = (_e127 < 0f);
                    } else {
                        phi_306_ = true;
                    }
                    let _e133 = phi_306_;
                    if _e133 {
                        if (_e127 > 0f) {
                            phi_324_ = bitcast<f32>((_e128 + 1u));
                        } else {
                            if (_e127 < 0f) {
                                phi_323_ = bitcast<f32>((_e128 - 1u));
                            } else {
                                phi_323_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e139 = phi_323_;
                            phi_324_ = _e139;
                        }
                        let _e143 = phi_324_;
                        phi_325_ = _e143;
                    } else {
                        phi_325_ = _e127;
                    }
                    let _e145 = phi_325_;
                    local_1.member[_e118.member_1] = -(_e145);
                    let _e151 = local_1.member_1[_e118.member_1];
                    let _e152 = (_e151 + _e43);
                    let _e153 = bitcast<u32>(_e152);
                    if ((_e153 & 2139095040u) == 2139095040u) {
                        phi_352_ = (_e152 < 0f);
                    } else {
                        phi_352_ = true;
                    }
                    let _e158 = phi_352_;
                    if _e158 {
                        if (_e152 > 0f) {
                            phi_370_ = bitcast<f32>((_e153 + 1u));
                        } else {
                            if (_e152 < 0f) {
                                phi_369_ = bitcast<f32>((_e153 - 1u));
                            } else {
                                phi_369_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e164 = phi_369_;
                            phi_370_ = _e164;
                        }
                        let _e168 = phi_370_;
                        phi_371_ = _e168;
                    } else {
                        phi_371_ = _e152;
                    }
                    let _e170 = phi_371_;
                    local_1.member_1[_e118.member_1] = _e170;
                }
                continue;
                continuing {
                    phi_255_ = _e116;
                    break if !(_e122);
                }
            }
        } else {
            local_1 = _e101;
        }
        let _e174 = local_1;
        local_4 = _e174;
        local = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_415_ = type_16(0u, 3u);
        loop {
            let _e176 = phi_415_;
            if (_e176.member < _e176.member_1) {
                phi_416_ = type_16((_e176.member + 1u), _e176.member_1);
                phi_439_ = type_16(1u, _e176.member);
            } else {
                phi_416_ = _e176;
                phi_439_ = type_16(0u, type_16().member_1);
            }
            let _e188 = phi_416_;
            let _e190 = phi_439_;
            let _e194 = (bitcast<i32>(_e190.member) != 0i);
            if _e194 {
                let _e197 = local_4.member[_e190.member_1];
                if (_e197 > _e197) {
                    let _e199 = -(_e197);
                    let _e200 = bitcast<u32>(_e199);
                    if ((_e200 & 2139095040u) == 2139095040u) {
                        phi_469_ = (_e199 < 0f);
                    } else {
                        phi_469_ = true;
                    }
                    let _e205 = phi_469_;
                    if _e205 {
                        if (_e199 > 0f) {
                            phi_487_ = bitcast<f32>((_e200 + 1u));
                        } else {
                            if (_e199 < 0f) {
                                phi_486_ = bitcast<f32>((_e200 - 1u));
                            } else {
                                phi_486_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e211 = phi_486_;
                            phi_487_ = _e211;
                        }
                        let _e215 = phi_487_;
                        phi_488_ = _e215;
                    } else {
                        phi_488_ = _e199;
                    }
                    let _e217 = phi_488_;
                    phi_490_ = -(_e217);
                } else {
                    phi_490_ = _e197;
                }
                let _e220 = phi_490_;
                let _e221 = -(290000000000000000000000000000000000000f);
                if (_e220 > _e221) {
                    phi_496_ = _e220;
                } else {
                    phi_496_ = _e221;
                }
                let _e224 = phi_496_;
                if (_e224 < 290000000000000000000000000000000000000f) {
                    phi_501_ = _e224;
                } else {
                    phi_501_ = 290000000000000000000000000000000000000f;
                }
                let _e227 = phi_501_;
                local.member[_e190.member_1] = _e227;
                let _e232 = local_4.member_1[_e190.member_1];
                if (_e232 < _e232) {
                    let _e234 = bitcast<u32>(_e232);
                    if ((_e234 & 2139095040u) == 2139095040u) {
                        phi_530_ = (_e232 < 0f);
                    } else {
                        phi_530_ = true;
                    }
                    let _e239 = phi_530_;
                    if _e239 {
                        if (_e232 > 0f) {
                            phi_548_ = bitcast<f32>((_e234 + 1u));
                        } else {
                            if (_e232 < 0f) {
                                phi_547_ = bitcast<f32>((_e234 - 1u));
                            } else {
                                phi_547_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e245 = phi_547_;
                            phi_548_ = _e245;
                        }
                        let _e249 = phi_548_;
                        phi_549_ = _e249;
                    } else {
                        phi_549_ = _e232;
                    }
                    let _e251 = phi_549_;
                    phi_550_ = _e251;
                } else {
                    phi_550_ = _e232;
                }
                let _e253 = phi_550_;
                let _e254 = -(290000000000000000000000000000000000000f);
                if (_e253 > _e254) {
                    phi_556_ = _e253;
                } else {
                    phi_556_ = _e254;
                }
                let _e257 = phi_556_;
                if (_e257 < 290000000000000000000000000000000000000f) {
                    phi_561_ = _e257;
                } else {
                    phi_561_ = 290000000000000000000000000000000000000f;
                }
                let _e260 = phi_561_;
                local.member_1[_e190.member_1] = _e260;
            }
            continue;
            continuing {
                phi_415_ = _e188;
                break if !(_e194);
            }
        }
        let _e264 = local;
        boxes.member[_e35] = type_4(array<f32, 3>(_e264.member[0], _e264.member[1], _e264.member[2]), array<f32, 3>(_e264.member_1[0], _e264.member_1[1], _e264.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
