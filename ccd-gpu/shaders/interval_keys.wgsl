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

struct type_15 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_19 {
    member: type_15,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: type_19,
    member_1: u32,
}

@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(2) 
var<storage> survey: type_11;
@group(0) @binding(3) 
var<storage, read_write> keys: type_11;
@group(0) @binding(4) 
var<storage, read_write> order: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_15;
    var local_2: type_19;
    var local_3: type_15;
    var local_4: array<f32, 3>;
    var local_5: type_15;
    var local_6: type_19;
    var local_7: type_15;
    var phi_149_: u32;
    var phi_286_: type_9;
    var phi_485_: type_9;
    var phi_488_: type_22;
    var phi_521_: type_9;
    var phi_524_: bool;
    var phi_525_: bool;
    var local_8: bool;
    var phi_592_: type_22;
    var phi_593_: bool;
    var phi_489_: type_22;
    var phi_594_: bool;
    var phi_652_: type_9;
    var phi_655_: u32;
    var local_9: type_22;
    var local_10: type_22;
    var local_11: type_22;
    var local_12: type_22;
    var local_13: type_22;
    var local_14: type_22;
    var local_15: type_22;
    var local_16: type_22;
    var phi_746_: u32;
    var phi_747_: bool;
    var phi_656_: u32;
    var phi_749_: bool;
    var local_17: u32;
    var local_18: type_22;
    var local_19: u32;
    var local_20: type_22;
    var local_21: type_22;
    var local_22: type_22;
    var local_23: u32;
    var local_24: type_22;
    var local_25: type_22;
    var local_26: type_22;
    var phi_808_: type_9;
    var phi_901_: f32;
    var phi_934_: type_9;
    var phi_1049_: u32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_1050_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e59 = id_2;
    let _e60 = n_2;
    let _e61 = lane_2;
    let _e73 = ((((_e59.y * _e60.x) + _e59.x) * 256u) + _e61);
    let _e77 = params.member.member.member_2[3u];
    if (_e73 < _e77) {
        let _e82 = params.member.member.member_2[2u];
        if (_e73 >= _e82) {
            phi_149_ = 2u;
        } else {
            let _e85 = params.member.member.member_2[1u];
            phi_149_ = select(0u, 1u, (_e73 >= _e85));
        }
        let _e89 = phi_149_;
        let _e91 = boxes.member[_e73];
        local_7 = type_15(array<f32, 3>(_e91.member[0], _e91.member[1], _e91.member[2]), array<f32, 3>(_e91.member_1[0], _e91.member_1[1], _e91.member_1[2]));
        let _e105 = params.member.member_2.member;
        if (_e105 == 1u) {
            let _e596 = survey.member[6u];
            if (_e596 == 0u) {
                let _e607 = local_7.member[0u];
                phi_204_ = _e607;
            } else {
                if (_e596 == 1u) {
                    let _e603 = local_7.member[1u];
                    phi_203_ = _e603;
                } else {
                    let _e601 = local_7.member[2u];
                    phi_203_ = _e601;
                }
                let _e605 = phi_203_;
                phi_204_ = _e605;
            }
            let _e609 = phi_204_;
            let _e610 = bitcast<u32>(_e609);
            let _e614 = bitcast<u32>(bitcast<f32>(select(_e610, 0u, (_e610 == 2147483648u))));
            phi_1050_ = (select((_e614 | 2147483648u), ~(_e614), ((_e614 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i));
        } else {
            if (_e105 == 2u) {
                let _e109 = survey.member[6u];
                let _e116 = bitcast<f32>(select(~(_e109), (_e109 & 2147483647u), ((_e109 >> bitcast<u32>(31i)) == 1u)));
                let _e118 = survey.member[7u];
                let _e125 = bitcast<f32>(select(~(_e118), (_e118 & 2147483647u), ((_e118 >> bitcast<u32>(31i)) == 1u)));
                let _e127 = survey.member[8u];
                let _e134 = bitcast<f32>(select(~(_e127), (_e127 & 2147483647u), ((_e127 >> bitcast<u32>(31i)) == 1u)));
                local_5 = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_286_ = type_9(0u, 3u);
                loop {
                    let _e136 = phi_286_;
                    let _e139 = (_e136.member < _e136.member_1);
                    let _e150 = select(type_9().member_1, _e136.member, _e139);
                    let _e152 = (bitcast<i32>(select(0u, 1u, _e139)) != 0i);
                    if _e152 {
                        let _e154 = survey.member[_e150];
                        let _e155 = ~(_e154);
                        local_5.member[_e150] = bitcast<f32>(select(~(_e155), (_e155 & 2147483647u), ((_e155 >> bitcast<u32>(31i)) == 1u)));
                        let _e167 = survey.member[(3u + _e150)];
                        local_5.member_1[_e150] = bitcast<f32>(select(~(_e167), (_e167 & 2147483647u), ((_e167 >> bitcast<u32>(31i)) == 1u)));
                    }
                    continue;
                    continuing {
                        phi_286_ = type_9(select(_e136.member, (_e136.member + 1u), _e139), select(_e136.member_1, _e136.member_1, _e139));
                        break if !(_e152);
                    }
                }
                let _e178 = local_5;
                local_6 = type_19(_e178, array<f32, 3>(_e116, _e125, _e134));
                let _e198 = local_6.member.member_1[0u];
                let _e202 = local_6.member.member[0u];
                let _e207 = local_6.member.member_1[1u];
                let _e211 = local_6.member.member[1u];
                let _e216 = local_6.member.member_1[2u];
                let _e220 = local_6.member.member[2u];
                local_4 = array<f32, 3>(((_e198 * 0.5f) - (_e202 * 0.5f)), ((_e207 * 0.5f) - (_e211 * 0.5f)), ((_e216 * 0.5f) - (_e220 * 0.5f)));
                phi_485_ = type_9(0u, 9u);
                phi_488_ = type_22(type_19(type_15(array<f32, 3>(_e178.member[0], _e178.member[1], _e178.member[2]), array<f32, 3>(_e178.member_1[0], _e178.member_1[1], _e178.member_1[2])), array<f32, 3>(_e116, _e125, _e134)), 0u);
                loop {
                    let _e225 = phi_485_;
                    let _e227 = phi_488_;
                    local_9 = _e227;
                    local_10 = _e227;
                    local_11 = _e227;
                    local_12 = _e227;
                    local_13 = _e227;
                    local_14 = _e227;
                    local_15 = _e227;
                    local_16 = _e227;
                    local_18 = _e227;
                    local_20 = _e227;
                    local_21 = _e227;
                    local_22 = _e227;
                    local_24 = _e227;
                    local_25 = _e227;
                    local_26 = _e227;
                    let _e230 = (_e225.member < _e225.member_1);
                    let _e241 = select(type_9().member_1, _e225.member, _e230);
                    if (bitcast<i32>(select(0u, 1u, _e230)) != 0i) {
                        phi_521_ = type_9(0u, 3u);
                        phi_524_ = true;
                        loop {
                            let _e245 = phi_521_;
                            let _e247 = phi_524_;
                            local_8 = _e247;
                            let _e250 = (_e245.member < _e245.member_1);
                            let _e261 = select(type_9().member_1, _e245.member, _e250);
                            let _e263 = (bitcast<i32>(select(0u, 1u, _e250)) != 0i);
                            if _e263 {
                                let _e265 = local_4[_e261];
                                let _e267 = (_e265 * (1f / 512f));
                                let _e272 = local_6.member_1[_e261];
                                phi_525_ = select(_e247, false, ((_e272 * bitcast<f32>(((127u - _e241) << bitcast<u32>(23i)))) > select(0.000000000000000000000000000006310887f, _e267, (_e267 > 0.000000000000000000000000000006310887f))));
                            } else {
                                phi_525_ = bool();
                            }
                            let _e281 = phi_525_;
                            continue;
                            continuing {
                                phi_521_ = type_9(select(_e245.member, (_e245.member + 1u), _e250), select(_e245.member_1, _e245.member_1, _e250));
                                phi_524_ = _e281;
                                break if !(_e263);
                            }
                        }
                        let _e284 = local_8;
                        if _e284 {
                            phi_592_ = type_22();
                            phi_593_ = false;
                        } else {
                            phi_592_ = type_22(_e227.member, (_e241 + 1u));
                            phi_593_ = true;
                        }
                        let _e289 = phi_592_;
                        let _e291 = phi_593_;
                        phi_489_ = _e289;
                        phi_594_ = _e291;
                    } else {
                        phi_489_ = type_22();
                        phi_594_ = false;
                    }
                    let _e293 = phi_489_;
                    let _e295 = phi_594_;
                    continue;
                    continuing {
                        phi_485_ = type_9(select(_e225.member, (_e225.member + 1u), _e230), select(_e225.member_1, _e225.member_1, _e230));
                        phi_488_ = _e293;
                        break if !(_e295);
                    }
                }
                let _e299 = local_7.member_1[0u];
                let _e303 = local_7.member[0u];
                let _e308 = local_7.member_1[1u];
                let _e312 = local_7.member[1u];
                let _e317 = local_7.member_1[2u];
                let _e321 = local_7.member[2u];
                phi_652_ = type_9(1u, 8u);
                phi_655_ = 0u;
                loop {
                    let _e325 = phi_652_;
                    let _e327 = phi_655_;
                    local_17 = _e327;
                    local_19 = _e327;
                    local_23 = _e327;
                    let _e330 = (_e325.member < _e325.member_1);
                    if (bitcast<i32>(select(0u, 1u, _e330)) != 0i) {
                        let _e344 = local_9;
                        let _e348 = local_10;
                        if ((_e327 + 1u) >= select(8u, (_e348.member_1 + 1u), (_e344.member_1 < 8u))) {
                            phi_746_ = u32();
                            phi_747_ = false;
                        } else {
                            let _e355 = local_11;
                            let _e359 = local_12;
                            let _e365 = local_13;
                            let _e372 = bitcast<f32>(((127u - select((_e365.member_1 - _e327), 0u, ((_e327 + 1u) >= select(8u, (_e359.member_1 + 1u), (_e355.member_1 < 8u))))) << bitcast<u32>(23i)));
                            let _e374 = local_14;
                            let _e380 = local_15;
                            let _e386 = local_16;
                            let _e391 = (((_e299 * 0.5f) - (_e303 * 0.5f)) <= (_e374.member.member_1[0] * _e372));
                            let _e392 = (((_e308 * 0.5f) - (_e312 * 0.5f)) <= (_e380.member.member_1[1] * _e372));
                            let _e398 = select(select(bool(), select(bool(), (((_e317 * 0.5f) - (_e321 * 0.5f)) <= (_e386.member.member_1[2] * _e372)), _e392), _e391), false, select(true, select(true, false, _e392), _e391));
                            phi_746_ = select((_e327 + 1u), u32(), _e398);
                            phi_747_ = select(true, false, _e398);
                        }
                        let _e403 = phi_746_;
                        let _e405 = phi_747_;
                        phi_656_ = _e403;
                        phi_749_ = _e405;
                    } else {
                        phi_656_ = u32();
                        phi_749_ = false;
                    }
                    let _e407 = phi_656_;
                    let _e409 = phi_749_;
                    continue;
                    continuing {
                        phi_652_ = type_9(select(_e325.member, (_e325.member + 1u), _e330), select(_e325.member_1, _e325.member_1, _e330));
                        phi_655_ = _e407;
                        break if !(_e409);
                    }
                }
                let _e412 = local_17;
                let _e416 = local_18;
                let _e420 = local_19;
                let _e423 = local_20;
                let _e427 = local_21;
                let _e433 = local_22;
                let _e436 = local_23;
                let _e442 = bitcast<f32>(((127u - select((_e433.member_1 - _e436), 0u, ((_e420 + 1u) >= select(8u, (_e427.member_1 + 1u), (_e423.member_1 < 8u))))) << bitcast<u32>(23i)));
                let _e444 = local_24;
                let _e450 = local_25;
                let _e456 = local_26;
                local_2.member = type_15(array<f32, 3>(_e416.member.member.member[0], _e416.member.member.member[1], _e416.member.member.member[2]), array<f32, 3>(_e416.member.member.member_1[0], _e416.member.member.member_1[1], _e416.member.member.member_1[2]));
                local_2.member_1 = array<f32, 3>((_e444.member.member_1[0] * _e442), (_e450.member.member_1[1] * _e442), (_e456.member.member_1[2] * _e442));
                local_1.member = array<f32, 3>(0f, 0f, 0f);
                local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                phi_808_ = type_9(0u, 3u);
                loop {
                    let _e478 = phi_808_;
                    let _e481 = (_e478.member < _e478.member_1);
                    let _e492 = select(type_9().member_1, _e478.member, _e481);
                    let _e494 = (bitcast<i32>(select(0u, 1u, _e481)) != 0i);
                    if _e494 {
                        let _e498 = local_2.member.member[_e492];
                        let _e502 = local_2.member.member_1[_e492];
                        let _e507 = (((_e502 * 0.5f) - (_e498 * 0.5f)) * (1f / 512f));
                        let _e510 = local_2.member_1[_e492];
                        let _e513 = local_2.member_1[_e492];
                        let _e515 = (_e510 + (_e513 * 0.00390625f));
                        let _e517 = select(_e515, _e507, (_e507 > _e515));
                        let _e519 = select(_e517, 0.000000000000000000000000000006310887f, (0.000000000000000000000000000006310887f > _e517));
                        local_1.member[_e492] = (_e498 * 0.25f);
                        if (_e519 > 5316912000000000000000000000000000000f) {
                            phi_901_ = 0f;
                        } else {
                            phi_901_ = (1f / _e519);
                        }
                        let _e526 = phi_901_;
                        local_1.member_1[_e492] = _e526;
                    }
                    continue;
                    continuing {
                        phi_808_ = type_9(select(_e478.member, (_e478.member + 1u), _e481), select(_e478.member_1, _e478.member_1, _e481));
                        break if !(_e494);
                    }
                }
                let _e530 = local_1;
                local_3 = _e530;
                local = array<u32, 3>(0u, 0u, 0u);
                phi_934_ = type_9(0u, 3u);
                loop {
                    let _e532 = phi_934_;
                    let _e535 = (_e532.member < _e532.member_1);
                    let _e546 = select(type_9().member_1, _e532.member, _e535);
                    let _e548 = (bitcast<i32>(select(0u, 1u, _e535)) != 0i);
                    if _e548 {
                        let _e551 = local_3.member[_e546];
                        let _e554 = local_7.member[_e546];
                        let _e556 = ((_e554 * 0.25f) - _e551);
                        let _e561 = local_7.member_1[_e546];
                        let _e563 = ((_e561 * 0.25f) - _e551);
                        let _e569 = local_3.member_1[_e546];
                        let _e570 = ((select(0f, _e556, (_e556 > 0f)) + select(0f, _e563, (_e563 > 0f))) * _e569);
                        local[_e546] = select(select(0u, select(select(u32(_e570), 0u, (_e570 < 0f)), 4294967295u, (_e570 > 4294967000f)), (_e570 > 0f)), 511u, (_e570 >= 511f));
                    }
                    continue;
                    continuing {
                        phi_934_ = type_9(select(_e532.member, (_e532.member + 1u), _e535), select(_e532.member_1, _e532.member_1, _e535));
                        break if !(_e548);
                    }
                }
                let _e582 = local;
                phi_1049_ = ((_e412 << bitcast<u32>(27u)) | (((_e582[2] << bitcast<u32>(18u)) | (_e582[1] << bitcast<u32>(9u))) | _e582[0]));
            } else {
                phi_1049_ = 0u;
            }
            let _e594 = phi_1049_;
            phi_1050_ = _e594;
        }
        let _e624 = phi_1050_;
        keys.member[_e73] = ((_e89 << bitcast<u32>(30u)) | _e624);
        order.member[_e73] = _e73;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn interval_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
