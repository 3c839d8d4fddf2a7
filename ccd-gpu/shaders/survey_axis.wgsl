// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_6 {
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

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_8 {
    member: u32,
    member_1: u32,
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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_19 {
    member: u32,
}

struct type_20 {
    member: type_6,
    member_1: type_7,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: f32,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
}

@group(0) @binding(1) 
var<storage> boxes: type_18;
@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(2) 
var<storage, read_write> survey: type_10;
var<workgroup> shared_: array<type_22, 256>;

fn function_(lane_1: u32) {
    var local: type_22;
    var local_1: type_22;
    var local_2: type_22;
    var local_3: type_22;
    var local_4: type_16;
    var local_5: type_22;
    var phi_101_: type_8;
    var phi_102_: type_8;
    var phi_125_: type_8;
    var phi_255_: type_8;
    var phi_256_: type_8;
    var phi_279_: type_8;
    var phi_404_: type_13;
    var phi_407_: u32;
    var phi_428_: bool;
    var phi_434_: type_14;
    var phi_405_: type_13;
    var phi_448_: type_14;
    var phi_505_: type_8;
    var phi_506_: type_8;
    var phi_529_: type_8;
    var phi_408_: u32;
    var phi_679_: u32;
    var phi_674_: u32;
    var phi_680_: u32;
    var phi_689_: u32;
    var phi_690_: u32;
    var phi_691_: u32;
    var phi_714_: array<u32, 3>;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e32 = lane_2;
    local_2 = type_22(0f, array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
    phi_101_ = type_8(0u, 32u);
    loop {
        let _e37 = phi_101_;
        if (_e37.member < _e37.member_1) {
            phi_102_ = type_8((_e37.member + 1u), _e37.member_1);
            phi_125_ = type_8(1u, _e37.member);
        } else {
            phi_102_ = _e37;
            phi_125_ = type_8(0u, type_8().member_1);
        }
        let _e49 = phi_102_;
        let _e51 = phi_125_;
        let _e55 = (bitcast<i32>(_e51.member) != 0i);
        if _e55 {
            let _e60 = params.member.member_1.member_1;
            let _e61 = (((_e51.member_1 * 256u) + _e32) * _e60);
            let _e64 = params.member.member_1.member;
            if (_e61 < _e64) {
                let _e67 = boxes.member[_e61];
                local_4 = type_16(array<f32, 3>(_e67.member[0], _e67.member[1], _e67.member[2]), array<f32, 3>(_e67.member_1[0], _e67.member_1[1], _e67.member_1[2]));
                let _e81 = local_4.member[0u];
                let _e85 = local_4.member_1[0u];
                let _e90 = local_4.member[1u];
                let _e94 = local_4.member_1[1u];
                let _e99 = local_4.member[2u];
                let _e103 = local_4.member_1[2u];
                local_3 = type_22(1f, array<f32, 3>(((_e81 * 0.5f) + (_e85 * 0.5f)), ((_e90 * 0.5f) + (_e94 * 0.5f)), ((_e99 * 0.5f) + (_e103 * 0.5f))), array<f32, 3>(0f, 0f, 0f));
                let _e109 = local_2.member;
                let _e111 = local_3.member;
                let _e112 = (_e109 + _e111);
                if (_e112 > 0f) {
                    local_1.member = _e112;
                    let _e118 = local_2.member_1;
                    local_1.member_1 = _e118;
                    let _e121 = local_2.member_2;
                    local_1.member_2 = _e121;
                    let _e123 = local_3.member;
                    let _e124 = (_e123 / _e112);
                    phi_255_ = type_8(0u, 3u);
                    loop {
                        let _e126 = phi_255_;
                        if (_e126.member < _e126.member_1) {
                            phi_256_ = type_8((_e126.member + 1u), _e126.member_1);
                            phi_279_ = type_8(1u, _e126.member);
                        } else {
                            phi_256_ = _e126;
                            phi_279_ = type_8(0u, type_8().member_1);
                        }
                        let _e138 = phi_256_;
                        let _e140 = phi_279_;
                        let _e144 = (bitcast<i32>(_e140.member) != 0i);
                        if _e144 {
                            let _e147 = local_3.member_1[_e140.member_1];
                            let _e150 = local_2.member_1[_e140.member_1];
                            let _e151 = (_e147 - _e150);
                            let _e154 = local_2.member_1[_e140.member_1];
                            local_1.member_1[_e140.member_1] = (_e154 + (_e151 * _e124));
                            let _e161 = local_2.member_2[_e140.member_1];
                            let _e164 = local_3.member_2[_e140.member_1];
                            let _e168 = local_2.member;
                            local_1.member_2[_e140.member_1] = ((_e161 + _e164) + ((_e151 * _e151) * (_e168 * _e124)));
                        }
                        continue;
                        continuing {
                            phi_255_ = _e138;
                            break if !(_e144);
                        }
                    }
                } else {
                    let _e114 = local_2;
                    local_1 = _e114;
                }
                let _e175 = local_1;
                local_2 = _e175;
            }
        }
        continue;
        continuing {
            phi_101_ = _e49;
            break if !(_e55);
        }
    }
    let _e177 = local_2;
    shared_[_e32] = _e177;
    phi_404_ = type_13(0i, 8i);
    phi_407_ = 128u;
    loop {
        let _e180 = phi_404_;
        let _e182 = phi_407_;
        if (_e180.member < _e180.member_1) {
            let _e189 = (_e180.member + 1i);
            if ((false == (_e189 > _e180.member)) != false) {
                phi_428_ = true;
            } else {
                phi_428_ = false;
            }
            let _e194 = phi_428_;
            if _e194 {
                phi_434_ = type_14(0u, type_14().member_1);
            } else {
                phi_434_ = type_14(1u, _e189);
            }
            let _e199 = phi_434_;
            phi_405_ = type_13(_e199.member_1, _e180.member_1);
            phi_448_ = type_14(1u, _e180.member);
        } else {
            phi_405_ = _e180;
            phi_448_ = type_14(0u, type_14().member_1);
        }
        let _e205 = phi_405_;
        let _e207 = phi_448_;
        let _e210 = (bitcast<i32>(_e207.member) != 0i);
        if _e210 {
            workgroupBarrier();
            if (_e32 < _e182) {
                let _e214 = shared_[(_e32 + _e182)];
                local_5 = _e214;
                let _e216 = local_2.member;
                let _e218 = local_5.member;
                let _e219 = (_e216 + _e218);
                if (_e219 > 0f) {
                    local.member = _e219;
                    let _e225 = local_2.member_1;
                    local.member_1 = _e225;
                    let _e228 = local_2.member_2;
                    local.member_2 = _e228;
                    let _e230 = local_5.member;
                    let _e231 = (_e230 / _e219);
                    phi_505_ = type_8(0u, 3u);
                    loop {
                        let _e233 = phi_505_;
                        if (_e233.member < _e233.member_1) {
                            phi_506_ = type_8((_e233.member + 1u), _e233.member_1);
                            phi_529_ = type_8(1u, _e233.member);
                        } else {
                            phi_506_ = _e233;
                            phi_529_ = type_8(0u, type_8().member_1);
                        }
                        let _e245 = phi_506_;
                        let _e247 = phi_529_;
                        let _e251 = (bitcast<i32>(_e247.member) != 0i);
                        if _e251 {
                            let _e254 = local_5.member_1[_e247.member_1];
                            let _e257 = local_2.member_1[_e247.member_1];
                            let _e258 = (_e254 - _e257);
                            let _e261 = local_2.member_1[_e247.member_1];
                            local.member_1[_e247.member_1] = (_e261 + (_e258 * _e231));
                            let _e268 = local_2.member_2[_e247.member_1];
                            let _e271 = local_5.member_2[_e247.member_1];
                            let _e275 = local_2.member;
                            local.member_2[_e247.member_1] = ((_e268 + _e271) + ((_e258 * _e258) * (_e275 * _e231)));
                        }
                        continue;
                        continuing {
                            phi_505_ = _e245;
                            break if !(_e251);
                        }
                    }
                } else {
                    let _e221 = local_2;
                    local = _e221;
                }
                let _e282 = local;
                local_2 = _e282;
                let _e283 = local_2;
                shared_[_e32] = _e283;
            }
            phi_408_ = (_e182 / 2u);
        } else {
            phi_408_ = u32();
        }
        let _e287 = phi_408_;
        continue;
        continuing {
            phi_404_ = _e205;
            phi_407_ = _e287;
            break if !(_e210);
        }
    }
    if (_e32 == 0u) {
        let _e292 = local_2.member_2[0u];
        let _e295 = local_2.member_2[1u];
        let _e298 = local_2.member_2[2u];
        if (_e295 > _e292) {
            if (_e298 > _e295) {
                phi_674_ = 2u;
            } else {
                phi_674_ = 1u;
            }
            let _e305 = phi_674_;
            phi_680_ = _e305;
        } else {
            if (_e298 > _e292) {
                phi_679_ = 2u;
            } else {
                phi_679_ = 0u;
            }
            let _e302 = phi_679_;
            phi_680_ = _e302;
        }
        let _e307 = phi_680_;
        if (_e307 == 0u) {
            phi_690_ = 2u;
            phi_691_ = 1u;
        } else {
            if (_e307 == 1u) {
                phi_689_ = 2u;
            } else {
                phi_689_ = 1u;
            }
            let _e311 = phi_689_;
            phi_690_ = _e311;
            phi_691_ = 0u;
        }
        let _e313 = phi_690_;
        let _e315 = phi_691_;
        let _e320 = local_2.member_2[_e313];
        let _e321 = local_2.member_2[_e315];
        if (_e320 > _e321) {
            phi_714_ = array<u32, 3>(_e307, _e313, _e315);
        } else {
            phi_714_ = array<u32, 3>(_e307, _e315, _e313);
        }
        let _e326 = phi_714_;
        survey.member[6u] = _e326[0];
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_axis(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
