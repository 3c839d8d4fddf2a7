struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
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

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_23 {
    member: array<u32>,
}

struct type_32 {
    member: i32,
    member_1: i32,
}

struct type_33 {
    member: u32,
    member_1: i32,
}

struct type_34 {
    member: u32,
    member_1: u32,
}

struct type_39 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> boxes: type_19;
var<workgroup> shared_: array<type_6, 256>;
@group(0) @binding(2) 
var<storage, read_write> words: type_39;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: type_6;
    var local_3: type_6;
    var local_4: type_6;
    var phi_102_: type_34;
    var phi_105_: type_6;
    var phi_103_: type_34;
    var phi_128_: type_34;
    var phi_176_: type_34;
    var phi_177_: type_34;
    var phi_200_: type_34;
    var phi_226_: f32;
    var phi_253_: f32;
    var phi_273_: type_6;
    var phi_106_: type_6;
    var local_5: type_6;
    var local_6: type_6;
    var phi_311_: type_32;
    var phi_314_: u32;
    var phi_335_: bool;
    var phi_341_: type_33;
    var phi_312_: type_32;
    var phi_355_: type_33;
    var phi_393_: type_34;
    var phi_394_: type_34;
    var phi_417_: type_34;
    var phi_443_: f32;
    var phi_470_: f32;
    var phi_315_: u32;
    var phi_532_: type_34;
    var phi_533_: type_34;
    var phi_556_: type_34;
    var phi_602_: u32;
    var phi_583_: u32;
    var phi_603_: u32;

    let _e45 = id_1;
    let _e46 = n_1;
    let _e47 = lane_1;
    let _e59 = params.member.member_17;
    phi_102_ = type_34(0u, 8u);
    phi_105_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    loop {
        let _e61 = phi_102_;
        let _e63 = phi_105_;
        local_5 = _e63;
        local_6 = _e63;
        if (_e61.member < _e61.member_1) {
            phi_103_ = type_34((_e61.member + 1u), _e61.member_1);
            phi_128_ = type_34(1u, _e61.member);
        } else {
            phi_103_ = _e61;
            phi_128_ = type_34(0u, type_34().member_1);
        }
        let _e77 = phi_103_;
        let _e79 = phi_128_;
        let _e83 = (bitcast<i32>(_e79.member) != 0i);
        if _e83 {
            let _e85 = (((((_e45.y * _e46.x) + _e45.x) * 2048u) + _e47) + (_e79.member_1 * 256u));
            if (_e85 < _e59) {
                let _e88 = boxes.member[_e85];
                local_2 = type_6(array<f32, 3>(_e88.member[0], _e88.member[1], _e88.member[2]), array<f32, 3>(_e88.member_1[0], _e88.member_1[1], _e88.member_1[2]));
                local_1 = type_6(array<f32, 3>(_e63.member[0], _e63.member[1], _e63.member[2]), array<f32, 3>(_e63.member_1[0], _e63.member_1[1], _e63.member_1[2]));
                phi_176_ = type_34(0u, 3u);
                loop {
                    let _e112 = phi_176_;
                    if (_e112.member < _e112.member_1) {
                        phi_177_ = type_34((_e112.member + 1u), _e112.member_1);
                        phi_200_ = type_34(1u, _e112.member);
                    } else {
                        phi_177_ = _e112;
                        phi_200_ = type_34(0u, type_34().member_1);
                    }
                    let _e126 = phi_177_;
                    let _e128 = phi_200_;
                    let _e132 = (bitcast<i32>(_e128.member) != 0i);
                    if _e132 {
                        if (_e128.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e136 = local_1.member[_e128.member_1];
                        if (_e128.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e140 = local_2.member[_e128.member_1];
                        if (_e136 < _e140) {
                            phi_226_ = _e136;
                        } else {
                            phi_226_ = _e140;
                        }
                        let _e143 = phi_226_;
                        if (_e128.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local_1.member[_e128.member_1] = _e143;
                        if (_e128.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e150 = local_1.member_1[_e128.member_1];
                        if (_e128.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e154 = local_2.member_1[_e128.member_1];
                        if (_e150 > _e154) {
                            phi_253_ = _e150;
                        } else {
                            phi_253_ = _e154;
                        }
                        let _e157 = phi_253_;
                        if (_e128.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local_1.member_1[_e128.member_1] = _e157;
                    }
                    continue;
                    continuing {
                        phi_176_ = _e126;
                        break if !(_e132);
                    }
                }
                let _e162 = local_1;
                phi_273_ = type_6(array<f32, 3>(_e162.member[0], _e162.member[1], _e162.member[2]), array<f32, 3>(_e162.member_1[0], _e162.member_1[1], _e162.member_1[2]));
            } else {
                phi_273_ = _e63;
            }
            let _e175 = phi_273_;
            phi_106_ = _e175;
        } else {
            phi_106_ = type_6();
        }
        let _e177 = phi_106_;
        continue;
        continuing {
            phi_102_ = _e77;
            phi_105_ = _e177;
            break if !(_e83);
        }
    }
    let _e180 = local_5;
    let _e187 = local_6;
    local_3 = type_6(array<f32, 3>(_e180.member[0], _e180.member[1], _e180.member[2]), array<f32, 3>(_e187.member_1[0], _e187.member_1[1], _e187.member_1[2]));
    let _e194 = local_3;
    shared_[_e47] = _e194;
    phi_311_ = type_32(0i, 8i);
    phi_314_ = 128u;
    loop {
        let _e197 = phi_311_;
        let _e199 = phi_314_;
        if (_e197.member < _e197.member_1) {
            let _e207 = (_e197.member + 1i);
            if ((false == (_e207 > _e197.member)) != false) {
                phi_335_ = true;
            } else {
                phi_335_ = false;
            }
            let _e212 = phi_335_;
            if _e212 {
                phi_341_ = type_33(0u, type_33().member_1);
            } else {
                phi_341_ = type_33(1u, _e207);
            }
            let _e218 = phi_341_;
            if (bitcast<i32>(_e218.member) != 0i) {
            } else {
                return;
            }
            phi_312_ = type_32(_e218.member_1, _e197.member_1);
            phi_355_ = type_33(1u, _e197.member);
        } else {
            phi_312_ = _e197;
            phi_355_ = type_33(0u, type_33().member_1);
        }
        let _e228 = phi_312_;
        let _e230 = phi_355_;
        let _e233 = (bitcast<i32>(_e230.member) != 0i);
        if _e233 {
            workgroupBarrier();
            if (_e47 < _e199) {
                let _e237 = shared_[(_e47 + _e199)];
                local_4 = _e237;
                let _e238 = local_3;
                local = _e238;
                phi_393_ = type_34(0u, 3u);
                loop {
                    let _e240 = phi_393_;
                    if (_e240.member < _e240.member_1) {
                        phi_394_ = type_34((_e240.member + 1u), _e240.member_1);
                        phi_417_ = type_34(1u, _e240.member);
                    } else {
                        phi_394_ = _e240;
                        phi_417_ = type_34(0u, type_34().member_1);
                    }
                    let _e254 = phi_394_;
                    let _e256 = phi_417_;
                    let _e260 = (bitcast<i32>(_e256.member) != 0i);
                    if _e260 {
                        if (_e256.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e264 = local.member[_e256.member_1];
                        if (_e256.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e268 = local_4.member[_e256.member_1];
                        if (_e264 < _e268) {
                            phi_443_ = _e264;
                        } else {
                            phi_443_ = _e268;
                        }
                        let _e271 = phi_443_;
                        if (_e256.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member[_e256.member_1] = _e271;
                        if (_e256.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e278 = local.member_1[_e256.member_1];
                        if (_e256.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e282 = local_4.member_1[_e256.member_1];
                        if (_e278 > _e282) {
                            phi_470_ = _e278;
                        } else {
                            phi_470_ = _e282;
                        }
                        let _e285 = phi_470_;
                        if (_e256.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member_1[_e256.member_1] = _e285;
                    }
                    continue;
                    continuing {
                        phi_393_ = _e254;
                        break if !(_e260);
                    }
                }
                let _e290 = local;
                local_3 = _e290;
                let _e291 = local_3;
                shared_[_e47] = _e291;
            }
            phi_315_ = (_e199 / 2u);
        } else {
            phi_315_ = u32();
        }
        let _e295 = phi_315_;
        continue;
        continuing {
            phi_311_ = _e228;
            phi_314_ = _e295;
            break if !(_e233);
        }
    }
    if (_e47 == 0u) {
        phi_532_ = type_34(0u, 6u);
        loop {
            let _e299 = phi_532_;
            if (_e299.member < _e299.member_1) {
                phi_533_ = type_34((_e299.member + 1u), _e299.member_1);
                phi_556_ = type_34(1u, _e299.member);
            } else {
                phi_533_ = _e299;
                phi_556_ = type_34(0u, type_34().member_1);
            }
            let _e313 = phi_533_;
            let _e315 = phi_556_;
            let _e319 = (bitcast<i32>(_e315.member) != 0i);
            if _e319 {
                if (_e315.member_1 < 3u) {
                    if (_e315.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e337 = local_3.member[_e315.member_1];
                    let _e338 = bitcast<u32>(_e337);
                    if ((_e338 >> bitcast<u32>(31i)) == 1u) {
                        phi_583_ = ~(_e338);
                    } else {
                        phi_583_ = (_e338 | 2147483648u);
                    }
                    let _e345 = phi_583_;
                    phi_603_ = ~(_e345);
                } else {
                    let _e321 = (_e315.member_1 - 3u);
                    if (_e321 < 3u) {
                    } else {
                        return;
                    }
                    let _e325 = local_3.member_1[_e321];
                    let _e326 = bitcast<u32>(_e325);
                    if ((_e326 >> bitcast<u32>(31i)) == 1u) {
                        phi_602_ = ~(_e326);
                    } else {
                        phi_602_ = (_e326 | 2147483648u);
                    }
                    let _e333 = phi_602_;
                    phi_603_ = _e333;
                }
                let _e348 = phi_603_;
                let _e350 = atomicMax((&words.member[_e315.member_1]), _e348);
            }
            continue;
            continuing {
                phi_532_ = _e313;
                break if !(_e319);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn scene_bounds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
