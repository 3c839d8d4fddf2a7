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
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
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

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> boxes: type_18;
@group(0) @binding(2) 
var<storage, read_write> survey: type_10;
var<workgroup> shared_: array<type_22, 256>;

fn function_(lane_1: u32) {
    var local: type_22;
    var local_1: type_22;
    var local_2: type_22;
    var local_3: type_16;
    var local_4: type_16;
    var local_5: type_22;
    var local_6: type_22;
    var local_7: type_22;
    var phi_108_: type_8;
    var phi_170_: type_8;
    var phi_225_: type_8;
    var phi_293_: type_8;
    var phi_346_: type_8;
    var phi_401_: type_8;
    var phi_521_: type_8;
    var phi_670_: type_13;
    var phi_673_: u32;
    var phi_671_: type_13;
    var phi_714_: type_14;
    var phi_771_: type_8;
    var phi_674_: u32;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e34 = lane_2;
    local_5 = type_22(0f, array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
    phi_108_ = type_8(0u, 32u);
    loop {
        let _e39 = phi_108_;
        let _e42 = (_e39.member < _e39.member_1);
        let _e55 = (bitcast<i32>(select(0u, 1u, _e42)) != 0i);
        if _e55 {
            let _e60 = params.member.member_1.member_1;
            let _e61 = (((select(type_8().member_1, _e39.member, _e42) * 256u) + _e34) * _e60);
            let _e64 = params.member.member_1.member;
            if (_e61 < _e64) {
                local_2.member = 1f;
                local_2.member_1 = array<f32, 3>(0f, 0f, 0f);
                local_2.member_2 = array<f32, 3>(0f, 0f, 0f);
                phi_170_ = type_8(_e61, (_e61 + 1u));
                loop {
                    let _e72 = phi_170_;
                    let _e75 = (_e72.member < _e72.member_1);
                    let _e88 = (bitcast<i32>(select(0u, 1u, _e75)) != 0i);
                    if _e88 {
                        let _e90 = boxes.member[select(type_8().member_1, _e72.member, _e75)];
                        local_3 = type_16(array<f32, 3>(_e90.member[0], _e90.member[1], _e90.member[2]), array<f32, 3>(_e90.member_1[0], _e90.member_1[1], _e90.member_1[2]));
                        phi_225_ = type_8(0u, 3u);
                        loop {
                            let _e103 = phi_225_;
                            let _e106 = (_e103.member < _e103.member_1);
                            let _e117 = select(type_8().member_1, _e103.member, _e106);
                            let _e119 = (bitcast<i32>(select(0u, 1u, _e106)) != 0i);
                            if _e119 {
                                let _e122 = local_2.member_1[_e117];
                                let _e125 = local_3.member[_e117];
                                let _e129 = local_3.member_1[_e117];
                                local_2.member_1[_e117] = (_e122 + ((_e125 * 0.5f) + (_e129 * 0.5f)));
                            }
                            continue;
                            continuing {
                                phi_225_ = type_8(select(_e103.member, (_e103.member + 1u), _e106), select(_e103.member_1, _e103.member_1, _e106));
                                break if !(_e119);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_170_ = type_8(select(_e72.member, (_e72.member + 1u), _e75), select(_e72.member_1, _e72.member_1, _e75));
                        break if !(_e88);
                    }
                }
                phi_293_ = type_8(0u, 3u);
                loop {
                    let _e138 = phi_293_;
                    let _e141 = (_e138.member < _e138.member_1);
                    let _e152 = select(type_8().member_1, _e138.member, _e141);
                    let _e154 = (bitcast<i32>(select(0u, 1u, _e141)) != 0i);
                    if _e154 {
                        let _e157 = local_2.member_1[_e152];
                        let _e159 = local_2.member;
                        local_2.member_1[_e152] = (_e157 / _e159);
                    }
                    continue;
                    continuing {
                        phi_293_ = type_8(select(_e138.member, (_e138.member + 1u), _e141), select(_e138.member_1, _e138.member_1, _e141));
                        break if !(_e154);
                    }
                }
                phi_346_ = type_8(_e61, (_e61 + 1u));
                loop {
                    let _e167 = phi_346_;
                    let _e170 = (_e167.member < _e167.member_1);
                    let _e183 = (bitcast<i32>(select(0u, 1u, _e170)) != 0i);
                    if _e183 {
                        let _e185 = boxes.member[select(type_8().member_1, _e167.member, _e170)];
                        local_4 = type_16(array<f32, 3>(_e185.member[0], _e185.member[1], _e185.member[2]), array<f32, 3>(_e185.member_1[0], _e185.member_1[1], _e185.member_1[2]));
                        phi_401_ = type_8(0u, 3u);
                        loop {
                            let _e198 = phi_401_;
                            let _e201 = (_e198.member < _e198.member_1);
                            let _e212 = select(type_8().member_1, _e198.member, _e201);
                            let _e214 = (bitcast<i32>(select(0u, 1u, _e201)) != 0i);
                            if _e214 {
                                let _e217 = local_4.member[_e212];
                                let _e221 = local_4.member_1[_e212];
                                let _e226 = local_2.member_1[_e212];
                                let _e227 = (((_e217 * 0.5f) + (_e221 * 0.5f)) - _e226);
                                let _e230 = local_2.member_2[_e212];
                                local_2.member_2[_e212] = (_e230 + (_e227 * _e227));
                            }
                            continue;
                            continuing {
                                phi_401_ = type_8(select(_e198.member, (_e198.member + 1u), _e201), select(_e198.member_1, _e198.member_1, _e201));
                                break if !(_e214);
                            }
                        }
                    }
                    continue;
                    continuing {
                        phi_346_ = type_8(select(_e167.member, (_e167.member + 1u), _e170), select(_e167.member_1, _e167.member_1, _e170));
                        break if !(_e183);
                    }
                }
                let _e237 = local_2;
                local_6 = _e237;
                let _e239 = local_5.member;
                let _e241 = local_6.member;
                let _e242 = (_e239 + _e241);
                if (_e242 > 0f) {
                    local_1.member = _e242;
                    let _e248 = local_5.member_1;
                    local_1.member_1 = _e248;
                    let _e251 = local_5.member_2;
                    local_1.member_2 = _e251;
                    let _e253 = local_6.member;
                    let _e254 = (_e253 / _e242);
                    phi_521_ = type_8(0u, 3u);
                    loop {
                        let _e256 = phi_521_;
                        let _e259 = (_e256.member < _e256.member_1);
                        let _e270 = select(type_8().member_1, _e256.member, _e259);
                        let _e272 = (bitcast<i32>(select(0u, 1u, _e259)) != 0i);
                        if _e272 {
                            let _e275 = local_6.member_1[_e270];
                            let _e278 = local_5.member_1[_e270];
                            let _e279 = (_e275 - _e278);
                            let _e282 = local_5.member_1[_e270];
                            local_1.member_1[_e270] = (_e282 + (_e279 * _e254));
                            let _e289 = local_5.member_2[_e270];
                            let _e292 = local_6.member_2[_e270];
                            let _e296 = local_5.member;
                            local_1.member_2[_e270] = ((_e289 + _e292) + ((_e279 * _e279) * (_e296 * _e254)));
                        }
                        continue;
                        continuing {
                            phi_521_ = type_8(select(_e256.member, (_e256.member + 1u), _e259), select(_e256.member_1, _e256.member_1, _e259));
                            break if !(_e272);
                        }
                    }
                } else {
                    let _e244 = local_5;
                    local_1 = _e244;
                }
                let _e303 = local_1;
                local_5 = _e303;
            }
        }
        continue;
        continuing {
            phi_108_ = type_8(select(_e39.member, (_e39.member + 1u), _e42), select(_e39.member_1, _e39.member_1, _e42));
            break if !(_e55);
        }
    }
    let _e305 = local_5;
    shared_[_e34] = _e305;
    phi_670_ = type_13(0i, 8i);
    phi_673_ = 128u;
    loop {
        let _e308 = phi_670_;
        let _e310 = phi_673_;
        if (_e308.member < _e308.member_1) {
            let _e317 = (_e308.member + 1i);
            phi_671_ = type_13(select(_e317, type_14().member_1, select(false, true, ((false == (_e317 > _e308.member)) != false))), _e308.member_1);
            phi_714_ = type_14(1u, _e308.member);
        } else {
            phi_671_ = _e308;
            phi_714_ = type_14(0u, type_14().member_1);
        }
        let _e328 = phi_671_;
        let _e330 = phi_714_;
        let _e333 = (bitcast<i32>(_e330.member) != 0i);
        if _e333 {
            workgroupBarrier();
            if (_e34 < _e310) {
                let _e337 = shared_[(_e34 + _e310)];
                local_7 = _e337;
                let _e339 = local_5.member;
                let _e341 = local_7.member;
                let _e342 = (_e339 + _e341);
                if (_e342 > 0f) {
                    local.member = _e342;
                    let _e348 = local_5.member_1;
                    local.member_1 = _e348;
                    let _e351 = local_5.member_2;
                    local.member_2 = _e351;
                    let _e353 = local_7.member;
                    let _e354 = (_e353 / _e342);
                    phi_771_ = type_8(0u, 3u);
                    loop {
                        let _e356 = phi_771_;
                        let _e359 = (_e356.member < _e356.member_1);
                        let _e370 = select(type_8().member_1, _e356.member, _e359);
                        let _e372 = (bitcast<i32>(select(0u, 1u, _e359)) != 0i);
                        if _e372 {
                            let _e375 = local_7.member_1[_e370];
                            let _e378 = local_5.member_1[_e370];
                            let _e379 = (_e375 - _e378);
                            let _e382 = local_5.member_1[_e370];
                            local.member_1[_e370] = (_e382 + (_e379 * _e354));
                            let _e389 = local_5.member_2[_e370];
                            let _e392 = local_7.member_2[_e370];
                            let _e396 = local_5.member;
                            local.member_2[_e370] = ((_e389 + _e392) + ((_e379 * _e379) * (_e396 * _e354)));
                        }
                        continue;
                        continuing {
                            phi_771_ = type_8(select(_e356.member, (_e356.member + 1u), _e359), select(_e356.member_1, _e356.member_1, _e359));
                            break if !(_e372);
                        }
                    }
                } else {
                    let _e344 = local_5;
                    local = _e344;
                }
                let _e403 = local;
                local_5 = _e403;
                let _e404 = local_5;
                shared_[_e34] = _e404;
            }
            phi_674_ = (_e310 / 2u);
        } else {
            phi_674_ = u32();
        }
        let _e408 = phi_674_;
        continue;
        continuing {
            phi_670_ = _e328;
            phi_673_ = _e408;
            break if !(_e333);
        }
    }
    if (_e34 == 0u) {
        let _e413 = local_5.member_2[0u];
        let _e416 = local_5.member_2[1u];
        let _e419 = local_5.member_2[2u];
        survey.member[6u] = select(select(0u, 2u, (_e419 > _e413)), select(1u, 2u, (_e419 > _e416)), (_e416 > _e413));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_axis(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
