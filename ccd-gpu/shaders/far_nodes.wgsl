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

struct type_20 {
    member: array<vec4<u32>>,
}

struct type_22 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_27 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_29 {
    member: array<type_27>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> branches: type_20;
@group(0) @binding(2) 
var<storage> block_nodes: type_24;
@group(0) @binding(3) 
var<storage> far: type_11;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_29;

fn function_(param: bool, param_1: u32) -> u32 {
    return select(0u, param_1, param);
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_150_: type_9;
    var phi_223_: type_9;
    var phi_226_: type_26;
    var phi_228_: u32;
    var phi_230_: u32;
    var phi_282_: bool;
    var phi_307_: type_9;
    var phi_310_: type_26;
    var phi_311_: type_26;
    var phi_602_: type_9;
    var phi_605_: type_26;
    var phi_606_: type_26;
    var phi_882_: u32;
    var phi_887_: u32;
    var phi_227_: type_26;
    var phi_229_: u32;
    var phi_231_: u32;
    var phi_893_: type_9;
    var phi_896_: type_26;
    var phi_898_: u32;
    var phi_900_: u32;
    var phi_952_: bool;
    var phi_977_: type_9;
    var phi_980_: type_26;
    var phi_981_: type_26;
    var phi_1272_: type_9;
    var phi_1275_: type_26;
    var phi_1276_: type_26;
    var phi_1552_: u32;
    var phi_1557_: u32;
    var phi_897_: type_26;
    var phi_899_: u32;
    var phi_901_: u32;
    var local: type_26;
    var local_1: type_26;
    var local_2: type_26;
    var local_3: type_26;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var local_4: type_26;
    var local_5: type_26;
    var local_6: type_26;
    var local_7: type_26;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e43 = params.member.member_2.member_1;
    let _e45 = far.member[0u];
    let _e49 = params.member.member.member[_e43];
    let _e50 = (_e49 - 1u);
    let _e51 = ((_e24.x * _e24.y) * 128u);
    if (_e51 == 0u) {
        return;
    }
    let _e53 = (_e45 / _e51);
    if (_e51 == 0u) {
        return;
    }
    phi_150_ = type_9(0u, select(_e53, (_e53 + 1u), ((_e45 % _e51) > 0u)));
    loop {
        let _e61 = phi_150_;
        let _e64 = (_e61.member < _e61.member_1);
        if (bitcast<i32>(select(0u, 1u, _e64)) != 0i) {
            let _e79 = ((select(type_9().member_1, _e61.member, _e64) * _e51) + ((((_e23.y * _e24.x) + _e23.x) * 128u) + _e25));
            if (_e79 >= _e45) {
                phi_1603_ = false;
            } else {
                let _e83 = far.member[(4u + _e79)];
                let _e85 = branches.member[_e83];
                let _e92 = select(_e85.x, (_e85.x - _e50), (_e85.x >= _e50));
                phi_223_ = type_9(0u, 8u);
                phi_226_ = type_26(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_228_ = (_e92 + 1u);
                phi_230_ = _e85.z;
                loop {
                    let _e96 = phi_223_;
                    let _e98 = phi_226_;
                    let _e100 = phi_228_;
                    let _e102 = phi_230_;
                    local = _e98;
                    local_1 = _e98;
                    let _e105 = (_e96.member < _e96.member_1);
                    let _e116 = select(type_9().member_1, _e96.member, _e105);
                    let _e118 = (bitcast<i32>(select(0u, 1u, _e105)) != 0i);
                    if _e118 {
                        let _e119 = (_e102 % 32u);
                        let _e123 = select((_e102 + (32u - _e119)), _e102, (_e119 == 0u));
                        let _e125 = ((_e100 / 32u) * 32u);
                        if (_e123 < _e125) {
                            let _e128 = params.member.member_2.member_2;
                            phi_282_ = (_e116 < _e128);
                        } else {
                            phi_282_ = false;
                        }
                        let _e131 = phi_282_;
                        let _e132 = select(_e100, _e125, _e131);
                        let _e133 = select(_e100, _e123, _e131);
                        let _e134 = (_e133 - _e102);
                        let _e135 = (_e134 / 4u);
                        phi_307_ = type_9(0u, select(_e135, (_e135 + 1u), ((_e134 % 4u) > 0u)));
                        phi_310_ = _e98;
                        loop {
                            let _e142 = phi_307_;
                            let _e144 = phi_310_;
                            local_4 = _e144;
                            let _e147 = (_e142.member < _e142.member_1);
                            let _e160 = (bitcast<i32>(select(0u, 1u, _e147)) != 0i);
                            if _e160 {
                                let _e166 = params.member.member_2.member[_e116][_e43];
                                let _e167 = (_e166 + (_e102 + (4u * select(type_9().member_1, _e142.member, _e147))));
                                let _e171 = params.member.member_2.member[_e116][_e43];
                                let _e173 = ((_e171 + _e133) - 1u);
                                let _e175 = block_nodes.member[_e167];
                                let _e188 = (_e167 + 1u);
                                let _e192 = block_nodes.member[select(_e188, _e173, (_e173 < _e188))];
                                let _e205 = (_e167 + 2u);
                                let _e209 = block_nodes.member[select(_e205, _e173, (_e173 < _e205))];
                                let _e222 = (_e167 + 3u);
                                let _e226 = block_nodes.member[select(_e222, _e173, (_e173 < _e222))];
                                let _e240 = select(_e192.member.x, _e175.member.x, (_e175.member.x < _e192.member.x));
                                let _e242 = select(_e192.member.y, _e175.member.y, (_e175.member.y < _e192.member.y));
                                let _e244 = select(_e192.member_1.x, _e175.member_1.x, (_e175.member_1.x < _e192.member_1.x));
                                let _e246 = select(_e192.member_1.y, _e175.member_1.y, (_e175.member_1.y > _e192.member_1.y));
                                let _e248 = select(_e192.member_2.x, _e175.member_2.x, (_e175.member_2.x > _e192.member_2.x));
                                let _e250 = select(_e192.member_2.y, _e175.member_2.y, (_e175.member_2.y > _e192.member_2.y));
                                let _e252 = select(_e226.member.x, _e209.member.x, (_e209.member.x < _e226.member.x));
                                let _e254 = select(_e226.member.y, _e209.member.y, (_e209.member.y < _e226.member.y));
                                let _e256 = select(_e226.member_1.x, _e209.member_1.x, (_e209.member_1.x < _e226.member_1.x));
                                let _e258 = select(_e226.member_1.y, _e209.member_1.y, (_e209.member_1.y > _e226.member_1.y));
                                let _e260 = select(_e226.member_2.x, _e209.member_2.x, (_e209.member_2.x > _e226.member_2.x));
                                let _e262 = select(_e226.member_2.y, _e209.member_2.y, (_e209.member_2.y > _e226.member_2.y));
                                let _e264 = select(_e252, _e240, (_e240 < _e252));
                                let _e266 = select(_e254, _e242, (_e242 < _e254));
                                let _e268 = select(_e256, _e244, (_e244 < _e256));
                                let _e270 = select(_e258, _e246, (_e246 > _e258));
                                let _e272 = select(_e260, _e248, (_e248 > _e260));
                                let _e274 = select(_e262, _e250, (_e250 > _e262));
                                phi_311_ = type_26(array<f32, 3>(select(_e264, _e144.member[0], (_e144.member[0] < _e264)), select(_e266, _e144.member[1], (_e144.member[1] < _e266)), select(_e268, _e144.member[2], (_e144.member[2] < _e268))), array<f32, 3>(select(_e270, _e144.member_1[0], (_e144.member_1[0] > _e270)), select(_e272, _e144.member_1[1], (_e144.member_1[1] > _e272)), select(_e274, _e144.member_1[2], (_e144.member_1[2] > _e274))));
                            } else {
                                phi_311_ = type_26();
                            }
                            let _e303 = phi_311_;
                            continue;
                            continuing {
                                phi_307_ = type_9(select(_e142.member, (_e142.member + 1u), _e147), select(_e142.member_1, _e142.member_1, _e147));
                                phi_310_ = _e303;
                                break if !(_e160);
                            }
                        }
                        let _e305 = (_e100 - _e132);
                        let _e306 = (_e305 / 4u);
                        phi_602_ = type_9(0u, select(_e306, (_e306 + 1u), ((_e305 % 4u) > 0u)));
                        let _e955 = local_4;
                        phi_605_ = _e955;
                        loop {
                            let _e313 = phi_602_;
                            let _e315 = phi_605_;
                            local_5 = _e315;
                            let _e318 = (_e313.member < _e313.member_1);
                            let _e331 = (bitcast<i32>(select(0u, 1u, _e318)) != 0i);
                            if _e331 {
                                let _e337 = params.member.member_2.member[_e116][_e43];
                                let _e338 = (_e337 + (_e132 + (4u * select(type_9().member_1, _e313.member, _e318))));
                                let _e342 = params.member.member_2.member[_e116][_e43];
                                let _e344 = ((_e342 + _e100) - 1u);
                                let _e346 = block_nodes.member[_e338];
                                let _e359 = (_e338 + 1u);
                                let _e363 = block_nodes.member[select(_e359, _e344, (_e344 < _e359))];
                                let _e376 = (_e338 + 2u);
                                let _e380 = block_nodes.member[select(_e376, _e344, (_e344 < _e376))];
                                let _e393 = (_e338 + 3u);
                                let _e397 = block_nodes.member[select(_e393, _e344, (_e344 < _e393))];
                                let _e411 = select(_e363.member.x, _e346.member.x, (_e346.member.x < _e363.member.x));
                                let _e413 = select(_e363.member.y, _e346.member.y, (_e346.member.y < _e363.member.y));
                                let _e415 = select(_e363.member_1.x, _e346.member_1.x, (_e346.member_1.x < _e363.member_1.x));
                                let _e417 = select(_e363.member_1.y, _e346.member_1.y, (_e346.member_1.y > _e363.member_1.y));
                                let _e419 = select(_e363.member_2.x, _e346.member_2.x, (_e346.member_2.x > _e363.member_2.x));
                                let _e421 = select(_e363.member_2.y, _e346.member_2.y, (_e346.member_2.y > _e363.member_2.y));
                                let _e423 = select(_e397.member.x, _e380.member.x, (_e380.member.x < _e397.member.x));
                                let _e425 = select(_e397.member.y, _e380.member.y, (_e380.member.y < _e397.member.y));
                                let _e427 = select(_e397.member_1.x, _e380.member_1.x, (_e380.member_1.x < _e397.member_1.x));
                                let _e429 = select(_e397.member_1.y, _e380.member_1.y, (_e380.member_1.y > _e397.member_1.y));
                                let _e431 = select(_e397.member_2.x, _e380.member_2.x, (_e380.member_2.x > _e397.member_2.x));
                                let _e433 = select(_e397.member_2.y, _e380.member_2.y, (_e380.member_2.y > _e397.member_2.y));
                                let _e435 = select(_e423, _e411, (_e411 < _e423));
                                let _e437 = select(_e425, _e413, (_e413 < _e425));
                                let _e439 = select(_e427, _e415, (_e415 < _e427));
                                let _e441 = select(_e429, _e417, (_e417 > _e429));
                                let _e443 = select(_e431, _e419, (_e419 > _e431));
                                let _e445 = select(_e433, _e421, (_e421 > _e433));
                                phi_606_ = type_26(array<f32, 3>(select(_e435, _e315.member[0], (_e315.member[0] < _e435)), select(_e437, _e315.member[1], (_e315.member[1] < _e437)), select(_e439, _e315.member[2], (_e315.member[2] < _e439))), array<f32, 3>(select(_e441, _e315.member_1[0], (_e315.member_1[0] > _e441)), select(_e443, _e315.member_1[1], (_e315.member_1[1] > _e443)), select(_e445, _e315.member_1[2], (_e315.member_1[2] > _e445))));
                            } else {
                                phi_606_ = type_26();
                            }
                            let _e474 = phi_606_;
                            continue;
                            continuing {
                                phi_602_ = type_9(select(_e313.member, (_e313.member + 1u), _e318), select(_e313.member_1, _e313.member_1, _e318));
                                phi_605_ = _e474;
                                break if !(_e331);
                            }
                        }
                        if _e131 {
                            phi_882_ = (_e123 / 32u);
                        } else {
                            phi_882_ = 0u;
                        }
                        let _e478 = phi_882_;
                        if _e131 {
                            phi_887_ = (_e125 / 32u);
                        } else {
                            phi_887_ = 0u;
                        }
                        let _e481 = phi_887_;
                        let _e961 = local_5;
                        phi_227_ = _e961;
                        phi_229_ = _e481;
                        phi_231_ = _e478;
                    } else {
                        phi_227_ = type_26();
                        phi_229_ = u32();
                        phi_231_ = u32();
                    }
                    let _e483 = phi_227_;
                    let _e485 = phi_229_;
                    let _e487 = phi_231_;
                    continue;
                    continuing {
                        phi_223_ = type_9(select(_e96.member, (_e96.member + 1u), _e105), select(_e96.member_1, _e96.member_1, _e105));
                        phi_226_ = _e483;
                        phi_228_ = _e485;
                        phi_230_ = _e487;
                        break if !(_e118);
                    }
                }
                phi_893_ = type_9(0u, 8u);
                phi_896_ = type_26(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_898_ = (_e85.w + 1u);
                phi_900_ = (_e92 + 1u);
                loop {
                    let _e493 = phi_893_;
                    let _e495 = phi_896_;
                    let _e497 = phi_898_;
                    let _e499 = phi_900_;
                    local_2 = _e495;
                    local_3 = _e495;
                    let _e502 = (_e493.member < _e493.member_1);
                    let _e513 = select(type_9().member_1, _e493.member, _e502);
                    let _e515 = (bitcast<i32>(select(0u, 1u, _e502)) != 0i);
                    if _e515 {
                        let _e516 = (_e499 % 32u);
                        let _e520 = select((_e499 + (32u - _e516)), _e499, (_e516 == 0u));
                        let _e522 = ((_e497 / 32u) * 32u);
                        if (_e520 < _e522) {
                            let _e525 = params.member.member_2.member_2;
                            phi_952_ = (_e513 < _e525);
                        } else {
                            phi_952_ = false;
                        }
                        let _e528 = phi_952_;
                        let _e529 = select(_e497, _e522, _e528);
                        let _e530 = select(_e497, _e520, _e528);
                        let _e531 = (_e530 - _e499);
                        let _e532 = (_e531 / 4u);
                        phi_977_ = type_9(0u, select(_e532, (_e532 + 1u), ((_e531 % 4u) > 0u)));
                        phi_980_ = _e495;
                        loop {
                            let _e539 = phi_977_;
                            let _e541 = phi_980_;
                            local_6 = _e541;
                            let _e544 = (_e539.member < _e539.member_1);
                            let _e557 = (bitcast<i32>(select(0u, 1u, _e544)) != 0i);
                            if _e557 {
                                let _e563 = params.member.member_2.member[_e513][_e43];
                                let _e564 = (_e563 + (_e499 + (4u * select(type_9().member_1, _e539.member, _e544))));
                                let _e568 = params.member.member_2.member[_e513][_e43];
                                let _e570 = ((_e568 + _e530) - 1u);
                                let _e572 = block_nodes.member[_e564];
                                let _e585 = (_e564 + 1u);
                                let _e589 = block_nodes.member[select(_e585, _e570, (_e570 < _e585))];
                                let _e602 = (_e564 + 2u);
                                let _e606 = block_nodes.member[select(_e602, _e570, (_e570 < _e602))];
                                let _e619 = (_e564 + 3u);
                                let _e623 = block_nodes.member[select(_e619, _e570, (_e570 < _e619))];
                                let _e637 = select(_e589.member.x, _e572.member.x, (_e572.member.x < _e589.member.x));
                                let _e639 = select(_e589.member.y, _e572.member.y, (_e572.member.y < _e589.member.y));
                                let _e641 = select(_e589.member_1.x, _e572.member_1.x, (_e572.member_1.x < _e589.member_1.x));
                                let _e643 = select(_e589.member_1.y, _e572.member_1.y, (_e572.member_1.y > _e589.member_1.y));
                                let _e645 = select(_e589.member_2.x, _e572.member_2.x, (_e572.member_2.x > _e589.member_2.x));
                                let _e647 = select(_e589.member_2.y, _e572.member_2.y, (_e572.member_2.y > _e589.member_2.y));
                                let _e649 = select(_e623.member.x, _e606.member.x, (_e606.member.x < _e623.member.x));
                                let _e651 = select(_e623.member.y, _e606.member.y, (_e606.member.y < _e623.member.y));
                                let _e653 = select(_e623.member_1.x, _e606.member_1.x, (_e606.member_1.x < _e623.member_1.x));
                                let _e655 = select(_e623.member_1.y, _e606.member_1.y, (_e606.member_1.y > _e623.member_1.y));
                                let _e657 = select(_e623.member_2.x, _e606.member_2.x, (_e606.member_2.x > _e623.member_2.x));
                                let _e659 = select(_e623.member_2.y, _e606.member_2.y, (_e606.member_2.y > _e623.member_2.y));
                                let _e661 = select(_e649, _e637, (_e637 < _e649));
                                let _e663 = select(_e651, _e639, (_e639 < _e651));
                                let _e665 = select(_e653, _e641, (_e641 < _e653));
                                let _e667 = select(_e655, _e643, (_e643 > _e655));
                                let _e669 = select(_e657, _e645, (_e645 > _e657));
                                let _e671 = select(_e659, _e647, (_e647 > _e659));
                                phi_981_ = type_26(array<f32, 3>(select(_e661, _e541.member[0], (_e541.member[0] < _e661)), select(_e663, _e541.member[1], (_e541.member[1] < _e663)), select(_e665, _e541.member[2], (_e541.member[2] < _e665))), array<f32, 3>(select(_e667, _e541.member_1[0], (_e541.member_1[0] > _e667)), select(_e669, _e541.member_1[1], (_e541.member_1[1] > _e669)), select(_e671, _e541.member_1[2], (_e541.member_1[2] > _e671))));
                            } else {
                                phi_981_ = type_26();
                            }
                            let _e700 = phi_981_;
                            continue;
                            continuing {
                                phi_977_ = type_9(select(_e539.member, (_e539.member + 1u), _e544), select(_e539.member_1, _e539.member_1, _e544));
                                phi_980_ = _e700;
                                break if !(_e557);
                            }
                        }
                        let _e702 = (_e497 - _e529);
                        let _e703 = (_e702 / 4u);
                        phi_1272_ = type_9(0u, select(_e703, (_e703 + 1u), ((_e702 % 4u) > 0u)));
                        let _e975 = local_6;
                        phi_1275_ = _e975;
                        loop {
                            let _e710 = phi_1272_;
                            let _e712 = phi_1275_;
                            local_7 = _e712;
                            let _e715 = (_e710.member < _e710.member_1);
                            let _e728 = (bitcast<i32>(select(0u, 1u, _e715)) != 0i);
                            if _e728 {
                                let _e734 = params.member.member_2.member[_e513][_e43];
                                let _e735 = (_e734 + (_e529 + (4u * select(type_9().member_1, _e710.member, _e715))));
                                let _e739 = params.member.member_2.member[_e513][_e43];
                                let _e741 = ((_e739 + _e497) - 1u);
                                let _e743 = block_nodes.member[_e735];
                                let _e756 = (_e735 + 1u);
                                let _e760 = block_nodes.member[select(_e756, _e741, (_e741 < _e756))];
                                let _e773 = (_e735 + 2u);
                                let _e777 = block_nodes.member[select(_e773, _e741, (_e741 < _e773))];
                                let _e790 = (_e735 + 3u);
                                let _e794 = block_nodes.member[select(_e790, _e741, (_e741 < _e790))];
                                let _e808 = select(_e760.member.x, _e743.member.x, (_e743.member.x < _e760.member.x));
                                let _e810 = select(_e760.member.y, _e743.member.y, (_e743.member.y < _e760.member.y));
                                let _e812 = select(_e760.member_1.x, _e743.member_1.x, (_e743.member_1.x < _e760.member_1.x));
                                let _e814 = select(_e760.member_1.y, _e743.member_1.y, (_e743.member_1.y > _e760.member_1.y));
                                let _e816 = select(_e760.member_2.x, _e743.member_2.x, (_e743.member_2.x > _e760.member_2.x));
                                let _e818 = select(_e760.member_2.y, _e743.member_2.y, (_e743.member_2.y > _e760.member_2.y));
                                let _e820 = select(_e794.member.x, _e777.member.x, (_e777.member.x < _e794.member.x));
                                let _e822 = select(_e794.member.y, _e777.member.y, (_e777.member.y < _e794.member.y));
                                let _e824 = select(_e794.member_1.x, _e777.member_1.x, (_e777.member_1.x < _e794.member_1.x));
                                let _e826 = select(_e794.member_1.y, _e777.member_1.y, (_e777.member_1.y > _e794.member_1.y));
                                let _e828 = select(_e794.member_2.x, _e777.member_2.x, (_e777.member_2.x > _e794.member_2.x));
                                let _e830 = select(_e794.member_2.y, _e777.member_2.y, (_e777.member_2.y > _e794.member_2.y));
                                let _e832 = select(_e820, _e808, (_e808 < _e820));
                                let _e834 = select(_e822, _e810, (_e810 < _e822));
                                let _e836 = select(_e824, _e812, (_e812 < _e824));
                                let _e838 = select(_e826, _e814, (_e814 > _e826));
                                let _e840 = select(_e828, _e816, (_e816 > _e828));
                                let _e842 = select(_e830, _e818, (_e818 > _e830));
                                phi_1276_ = type_26(array<f32, 3>(select(_e832, _e712.member[0], (_e712.member[0] < _e832)), select(_e834, _e712.member[1], (_e712.member[1] < _e834)), select(_e836, _e712.member[2], (_e712.member[2] < _e836))), array<f32, 3>(select(_e838, _e712.member_1[0], (_e712.member_1[0] > _e838)), select(_e840, _e712.member_1[1], (_e712.member_1[1] > _e840)), select(_e842, _e712.member_1[2], (_e712.member_1[2] > _e842))));
                            } else {
                                phi_1276_ = type_26();
                            }
                            let _e871 = phi_1276_;
                            continue;
                            continuing {
                                phi_1272_ = type_9(select(_e710.member, (_e710.member + 1u), _e715), select(_e710.member_1, _e710.member_1, _e715));
                                phi_1275_ = _e871;
                                break if !(_e728);
                            }
                        }
                        if _e528 {
                            phi_1552_ = (_e520 / 32u);
                        } else {
                            phi_1552_ = 0u;
                        }
                        let _e875 = phi_1552_;
                        if _e528 {
                            phi_1557_ = (_e522 / 32u);
                        } else {
                            phi_1557_ = 0u;
                        }
                        let _e878 = phi_1557_;
                        let _e981 = local_7;
                        phi_897_ = _e981;
                        phi_899_ = _e878;
                        phi_901_ = _e875;
                    } else {
                        phi_897_ = type_26();
                        phi_899_ = u32();
                        phi_901_ = u32();
                    }
                    let _e880 = phi_897_;
                    let _e882 = phi_899_;
                    let _e884 = phi_901_;
                    continue;
                    continuing {
                        phi_893_ = type_9(select(_e493.member, (_e493.member + 1u), _e502), select(_e493.member_1, _e493.member_1, _e502));
                        phi_896_ = _e880;
                        phi_898_ = _e882;
                        phi_900_ = _e884;
                        break if !(_e515);
                    }
                }
                let _e887 = local;
                let _e890 = local_1;
                let _e893 = local_2;
                let _e896 = local_3;
                let _e899 = function_((_e85.x >= _e50), 1u);
                let _e901 = function_((_e85.y >= _e50), 2u);
                let _e906 = function_(((_e92 - _e85.z) < (_e85.w - _e92)), 4u);
                nodes.member[_e83] = type_27(vec4<u32>(bitcast<u32>(_e887.member[0]), bitcast<u32>(_e887.member[1]), bitcast<u32>(_e887.member[2]), 0u), vec4<u32>(bitcast<u32>(_e890.member_1[0]), bitcast<u32>(_e890.member_1[1]), bitcast<u32>(_e890.member_1[2]), 0u), vec4<u32>(bitcast<u32>(_e893.member[0]), bitcast<u32>(_e893.member[1]), bitcast<u32>(_e893.member[2]), _e92), vec4<u32>(bitcast<u32>(_e896.member_1[0]), bitcast<u32>(_e896.member_1[1]), bitcast<u32>(_e896.member_1[2]), ((_e899 | _e901) | _e906)));
                phi_1603_ = true;
            }
            let _e939 = phi_1603_;
            phi_1604_ = _e939;
        } else {
            phi_1604_ = false;
        }
        let _e941 = phi_1604_;
        continue;
        continuing {
            phi_150_ = type_9(select(_e61.member, (_e61.member + 1u), _e64), select(_e61.member_1, _e61.member_1, _e64));
            break if !(_e941);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn far_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
