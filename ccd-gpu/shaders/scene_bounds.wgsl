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

struct type_17 {
    member: i32,
    member_1: i32,
}

struct type_18 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_22 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_13;
var<workgroup> shared_: array<type_4, 256>;
@group(0) @binding(2) 
var<storage, read_write> words: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var local_2: type_4;
    var local_3: type_4;
    var local_4: type_4;
    var phi_102_: type_19;
    var phi_105_: type_4;
    var phi_103_: type_19;
    var phi_128_: type_19;
    var phi_176_: type_19;
    var phi_177_: type_19;
    var phi_200_: type_19;
    var phi_226_: f32;
    var phi_253_: f32;
    var phi_273_: type_4;
    var phi_106_: type_4;
    var local_5: type_4;
    var local_6: type_4;
    var phi_311_: type_17;
    var phi_314_: u32;
    var phi_335_: bool;
    var phi_341_: type_18;
    var phi_312_: type_17;
    var phi_355_: type_18;
    var phi_393_: type_19;
    var phi_394_: type_19;
    var phi_417_: type_19;
    var phi_443_: f32;
    var phi_470_: f32;
    var phi_315_: u32;
    var phi_532_: type_19;
    var phi_533_: type_19;
    var phi_556_: type_19;
    var phi_602_: u32;
    var phi_583_: u32;
    var phi_603_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e34 = id_2;
    let _e35 = n_2;
    let _e36 = lane_2;
    let _e48 = params.member.member_17;
    phi_102_ = type_19(0u, 8u);
    phi_105_ = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    loop {
        let _e50 = phi_102_;
        let _e52 = phi_105_;
        local_5 = _e52;
        local_6 = _e52;
        if (_e50.member < _e50.member_1) {
            phi_103_ = type_19((_e50.member + 1u), _e50.member_1);
            phi_128_ = type_19(1u, _e50.member);
        } else {
            phi_103_ = _e50;
            phi_128_ = type_19(0u, type_19().member_1);
        }
        let _e64 = phi_103_;
        let _e66 = phi_128_;
        let _e70 = (bitcast<i32>(_e66.member) != 0i);
        if _e70 {
            let _e72 = (((((_e34.y * _e35.x) + _e34.x) * 2048u) + _e36) + (_e66.member_1 * 256u));
            if (_e72 < _e48) {
                let _e75 = boxes.member[_e72];
                local_2 = type_4(array<f32, 3>(_e75.member[0], _e75.member[1], _e75.member[2]), array<f32, 3>(_e75.member_1[0], _e75.member_1[1], _e75.member_1[2]));
                local_1 = type_4(array<f32, 3>(_e52.member[0], _e52.member[1], _e52.member[2]), array<f32, 3>(_e52.member_1[0], _e52.member_1[1], _e52.member_1[2]));
                phi_176_ = type_19(0u, 3u);
                loop {
                    let _e99 = phi_176_;
                    if (_e99.member < _e99.member_1) {
                        phi_177_ = type_19((_e99.member + 1u), _e99.member_1);
                        phi_200_ = type_19(1u, _e99.member);
                    } else {
                        phi_177_ = _e99;
                        phi_200_ = type_19(0u, type_19().member_1);
                    }
                    let _e111 = phi_177_;
                    let _e113 = phi_200_;
                    let _e117 = (bitcast<i32>(_e113.member) != 0i);
                    if _e117 {
                        let _e120 = local_1.member[_e113.member_1];
                        let _e123 = local_2.member[_e113.member_1];
                        if (_e120 < _e123) {
                            phi_226_ = _e120;
                        } else {
                            phi_226_ = _e123;
                        }
                        let _e126 = phi_226_;
                        local_1.member[_e113.member_1] = _e126;
                        let _e131 = local_1.member_1[_e113.member_1];
                        let _e134 = local_2.member_1[_e113.member_1];
                        if (_e131 > _e134) {
                            phi_253_ = _e131;
                        } else {
                            phi_253_ = _e134;
                        }
                        let _e137 = phi_253_;
                        local_1.member_1[_e113.member_1] = _e137;
                    }
                    continue;
                    continuing {
                        phi_176_ = _e111;
                        break if !(_e117);
                    }
                }
                let _e141 = local_1;
                phi_273_ = type_4(array<f32, 3>(_e141.member[0], _e141.member[1], _e141.member[2]), array<f32, 3>(_e141.member_1[0], _e141.member_1[1], _e141.member_1[2]));
            } else {
                phi_273_ = _e52;
            }
            let _e154 = phi_273_;
            phi_106_ = _e154;
        } else {
            phi_106_ = type_4();
        }
        let _e156 = phi_106_;
        continue;
        continuing {
            phi_102_ = _e64;
            phi_105_ = _e156;
            break if !(_e70);
        }
    }
    let _e159 = local_5;
    let _e166 = local_6;
    local_3 = type_4(array<f32, 3>(_e159.member[0], _e159.member[1], _e159.member[2]), array<f32, 3>(_e166.member_1[0], _e166.member_1[1], _e166.member_1[2]));
    let _e173 = local_3;
    shared_[_e36] = _e173;
    phi_311_ = type_17(0i, 8i);
    phi_314_ = 128u;
    loop {
        let _e176 = phi_311_;
        let _e178 = phi_314_;
        if (_e176.member < _e176.member_1) {
            let _e185 = (_e176.member + 1i);
            if ((false == (_e185 > _e176.member)) != false) {
                phi_335_ = true;
            } else {
                phi_335_ = false;
            }
            let _e190 = phi_335_;
            if _e190 {
                phi_341_ = type_18(0u, type_18().member_1);
            } else {
                phi_341_ = type_18(1u, _e185);
            }
            let _e195 = phi_341_;
            phi_312_ = type_17(_e195.member_1, _e176.member_1);
            phi_355_ = type_18(1u, _e176.member);
        } else {
            phi_312_ = _e176;
            phi_355_ = type_18(0u, type_18().member_1);
        }
        let _e201 = phi_312_;
        let _e203 = phi_355_;
        let _e206 = (bitcast<i32>(_e203.member) != 0i);
        if _e206 {
            workgroupBarrier();
            if (_e36 < _e178) {
                let _e210 = shared_[(_e36 + _e178)];
                local_4 = _e210;
                let _e211 = local_3;
                local = _e211;
                phi_393_ = type_19(0u, 3u);
                loop {
                    let _e213 = phi_393_;
                    if (_e213.member < _e213.member_1) {
                        phi_394_ = type_19((_e213.member + 1u), _e213.member_1);
                        phi_417_ = type_19(1u, _e213.member);
                    } else {
                        phi_394_ = _e213;
                        phi_417_ = type_19(0u, type_19().member_1);
                    }
                    let _e225 = phi_394_;
                    let _e227 = phi_417_;
                    let _e231 = (bitcast<i32>(_e227.member) != 0i);
                    if _e231 {
                        let _e234 = local.member[_e227.member_1];
                        let _e237 = local_4.member[_e227.member_1];
                        if (_e234 < _e237) {
                            phi_443_ = _e234;
                        } else {
                            phi_443_ = _e237;
                        }
                        let _e240 = phi_443_;
                        local.member[_e227.member_1] = _e240;
                        let _e245 = local.member_1[_e227.member_1];
                        let _e248 = local_4.member_1[_e227.member_1];
                        if (_e245 > _e248) {
                            phi_470_ = _e245;
                        } else {
                            phi_470_ = _e248;
                        }
                        let _e251 = phi_470_;
                        local.member_1[_e227.member_1] = _e251;
                    }
                    continue;
                    continuing {
                        phi_393_ = _e225;
                        break if !(_e231);
                    }
                }
                let _e255 = local;
                local_3 = _e255;
                let _e256 = local_3;
                shared_[_e36] = _e256;
            }
            phi_315_ = (_e178 / 2u);
        } else {
            phi_315_ = u32();
        }
        let _e260 = phi_315_;
        continue;
        continuing {
            phi_311_ = _e201;
            phi_314_ = _e260;
            break if !(_e206);
        }
    }
    if (_e36 == 0u) {
        phi_532_ = type_19(0u, 6u);
        loop {
            let _e264 = phi_532_;
            if (_e264.member < _e264.member_1) {
                phi_533_ = type_19((_e264.member + 1u), _e264.member_1);
                phi_556_ = type_19(1u, _e264.member);
            } else {
                phi_533_ = _e264;
                phi_556_ = type_19(0u, type_19().member_1);
            }
            let _e276 = phi_533_;
            let _e278 = phi_556_;
            let _e282 = (bitcast<i32>(_e278.member) != 0i);
            if _e282 {
                if (_e278.member_1 < 3u) {
                    let _e298 = local_3.member[_e278.member_1];
                    let _e299 = bitcast<u32>(_e298);
                    if ((_e299 >> bitcast<u32>(31i)) == 1u) {
                        phi_583_ = ~(_e299);
                    } else {
                        phi_583_ = (_e299 | 2147483648u);
                    }
                    let _e306 = phi_583_;
                    phi_603_ = ~(_e306);
                } else {
                    let _e287 = local_3.member_1[(_e278.member_1 - 3u)];
                    let _e288 = bitcast<u32>(_e287);
                    if ((_e288 >> bitcast<u32>(31i)) == 1u) {
                        phi_602_ = ~(_e288);
                    } else {
                        phi_602_ = (_e288 | 2147483648u);
                    }
                    let _e295 = phi_602_;
                    phi_603_ = _e295;
                }
                let _e309 = phi_603_;
                let _e311 = atomicMax((&words.member[_e278.member_1]), _e309);
            }
            continue;
            continuing {
                phi_532_ = _e276;
                break if !(_e282);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn scene_bounds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
