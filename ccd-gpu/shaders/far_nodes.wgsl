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

struct type_25 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
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
var<storage, read_write> nodes: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_142_: type_9;
    var phi_215_: type_9;
    var phi_218_: type_29;
    var phi_220_: u32;
    var phi_222_: u32;
    var phi_274_: bool;
    var phi_299_: type_9;
    var phi_302_: type_29;
    var phi_303_: type_29;
    var phi_594_: type_9;
    var phi_597_: type_29;
    var phi_598_: type_29;
    var phi_874_: u32;
    var phi_879_: u32;
    var phi_219_: type_29;
    var phi_221_: u32;
    var phi_223_: u32;
    var phi_885_: type_9;
    var phi_888_: type_29;
    var phi_890_: u32;
    var phi_892_: u32;
    var phi_944_: bool;
    var phi_969_: type_9;
    var phi_972_: type_29;
    var phi_973_: type_29;
    var phi_1264_: type_9;
    var phi_1267_: type_29;
    var phi_1268_: type_29;
    var phi_1544_: u32;
    var phi_1549_: u32;
    var phi_889_: type_29;
    var phi_891_: u32;
    var phi_893_: u32;
    var local: type_29;
    var local_1: type_29;
    var local_2: type_29;
    var local_3: type_29;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var local_4: type_29;
    var local_5: type_29;
    var local_6: type_29;
    var local_7: type_29;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e24 = id_2;
    let _e25 = n_2;
    let _e26 = lane_2;
    let _e44 = params.member.member_2.member_1;
    let _e46 = far.member[0u];
    let _e50 = params.member.member.member[_e44];
    let _e51 = (_e50 - 1u);
    let _e52 = ((_e25.x * _e25.y) * 128u);
    if (_e52 == 0u) {
        return;
    }
    let _e54 = (_e46 / _e52);
    if (_e52 == 0u) {
        return;
    }
    phi_142_ = type_9(0u, select(_e54, (_e54 + 1u), ((_e46 % _e52) > 0u)));
    loop {
        let _e62 = phi_142_;
        let _e65 = (_e62.member < _e62.member_1);
        if (bitcast<i32>(select(0u, 1u, _e65)) != 0i) {
            let _e80 = ((select(type_9().member_1, _e62.member, _e65) * _e52) + ((((_e24.y * _e25.x) + _e24.x) * 128u) + _e26));
            if (_e80 >= _e46) {
                phi_1607_ = false;
            } else {
                let _e84 = far.member[(4u + _e80)];
                let _e86 = branches.member[_e84];
                let _e93 = select(_e86.x, (_e86.x - _e51), (_e86.x >= _e51));
                phi_215_ = type_9(0u, 8u);
                phi_218_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_220_ = (_e93 + 1u);
                phi_222_ = _e86.z;
                loop {
                    let _e97 = phi_215_;
                    let _e99 = phi_218_;
                    let _e101 = phi_220_;
                    let _e103 = phi_222_;
                    local = _e99;
                    local_1 = _e99;
                    let _e106 = (_e97.member < _e97.member_1);
                    let _e117 = select(type_9().member_1, _e97.member, _e106);
                    let _e119 = (bitcast<i32>(select(0u, 1u, _e106)) != 0i);
                    if _e119 {
                        let _e120 = (_e103 % 32u);
                        let _e124 = select((_e103 + (32u - _e120)), _e103, (_e120 == 0u));
                        let _e126 = ((_e101 / 32u) * 32u);
                        if (_e124 < _e126) {
                            let _e129 = params.member.member_2.member_2;
                            phi_274_ = (_e117 < _e129);
                        } else {
                            phi_274_ = false;
                        }
                        let _e132 = phi_274_;
                        let _e133 = select(_e101, _e126, _e132);
                        let _e134 = select(_e101, _e124, _e132);
                        let _e135 = (_e134 - _e103);
                        let _e136 = (_e135 / 4u);
                        phi_299_ = type_9(0u, select(_e136, (_e136 + 1u), ((_e135 % 4u) > 0u)));
                        phi_302_ = _e99;
                        loop {
                            let _e143 = phi_299_;
                            let _e145 = phi_302_;
                            local_4 = _e145;
                            let _e148 = (_e143.member < _e143.member_1);
                            let _e161 = (bitcast<i32>(select(0u, 1u, _e148)) != 0i);
                            if _e161 {
                                let _e167 = params.member.member_2.member[_e117][_e44];
                                let _e168 = (_e167 + (_e103 + (4u * select(type_9().member_1, _e143.member, _e148))));
                                let _e172 = params.member.member_2.member[_e117][_e44];
                                let _e174 = ((_e172 + _e134) - 1u);
                                let _e176 = block_nodes.member[_e168];
                                let _e189 = (_e168 + 1u);
                                let _e193 = block_nodes.member[select(_e189, _e174, (_e174 < _e189))];
                                let _e206 = (_e168 + 2u);
                                let _e210 = block_nodes.member[select(_e206, _e174, (_e174 < _e206))];
                                let _e223 = (_e168 + 3u);
                                let _e227 = block_nodes.member[select(_e223, _e174, (_e174 < _e223))];
                                let _e241 = select(_e193.member.x, _e176.member.x, (_e176.member.x < _e193.member.x));
                                let _e243 = select(_e193.member.y, _e176.member.y, (_e176.member.y < _e193.member.y));
                                let _e245 = select(_e193.member_1.x, _e176.member_1.x, (_e176.member_1.x < _e193.member_1.x));
                                let _e247 = select(_e193.member_1.y, _e176.member_1.y, (_e176.member_1.y > _e193.member_1.y));
                                let _e249 = select(_e193.member_2.x, _e176.member_2.x, (_e176.member_2.x > _e193.member_2.x));
                                let _e251 = select(_e193.member_2.y, _e176.member_2.y, (_e176.member_2.y > _e193.member_2.y));
                                let _e253 = select(_e227.member.x, _e210.member.x, (_e210.member.x < _e227.member.x));
                                let _e255 = select(_e227.member.y, _e210.member.y, (_e210.member.y < _e227.member.y));
                                let _e257 = select(_e227.member_1.x, _e210.member_1.x, (_e210.member_1.x < _e227.member_1.x));
                                let _e259 = select(_e227.member_1.y, _e210.member_1.y, (_e210.member_1.y > _e227.member_1.y));
                                let _e261 = select(_e227.member_2.x, _e210.member_2.x, (_e210.member_2.x > _e227.member_2.x));
                                let _e263 = select(_e227.member_2.y, _e210.member_2.y, (_e210.member_2.y > _e227.member_2.y));
                                let _e265 = select(_e253, _e241, (_e241 < _e253));
                                let _e267 = select(_e255, _e243, (_e243 < _e255));
                                let _e269 = select(_e257, _e245, (_e245 < _e257));
                                let _e271 = select(_e259, _e247, (_e247 > _e259));
                                let _e273 = select(_e261, _e249, (_e249 > _e261));
                                let _e275 = select(_e263, _e251, (_e251 > _e263));
                                phi_303_ = type_29(array<f32, 3>(select(_e265, _e145.member[0], (_e145.member[0] < _e265)), select(_e267, _e145.member[1], (_e145.member[1] < _e267)), select(_e269, _e145.member[2], (_e145.member[2] < _e269))), array<f32, 3>(select(_e271, _e145.member_1[0], (_e145.member_1[0] > _e271)), select(_e273, _e145.member_1[1], (_e145.member_1[1] > _e273)), select(_e275, _e145.member_1[2], (_e145.member_1[2] > _e275))));
                            } else {
                                phi_303_ = type_29();
                            }
                            let _e304 = phi_303_;
                            continue;
                            continuing {
                                phi_299_ = type_9(select(_e143.member, (_e143.member + 1u), _e148), select(_e143.member_1, _e143.member_1, _e148));
                                phi_302_ = _e304;
                                break if !(_e161);
                            }
                        }
                        let _e306 = (_e101 - _e133);
                        let _e307 = (_e306 / 4u);
                        phi_594_ = type_9(0u, select(_e307, (_e307 + 1u), ((_e306 % 4u) > 0u)));
                        let _e959 = local_4;
                        phi_597_ = _e959;
                        loop {
                            let _e314 = phi_594_;
                            let _e316 = phi_597_;
                            local_5 = _e316;
                            let _e319 = (_e314.member < _e314.member_1);
                            let _e332 = (bitcast<i32>(select(0u, 1u, _e319)) != 0i);
                            if _e332 {
                                let _e338 = params.member.member_2.member[_e117][_e44];
                                let _e339 = (_e338 + (_e133 + (4u * select(type_9().member_1, _e314.member, _e319))));
                                let _e343 = params.member.member_2.member[_e117][_e44];
                                let _e345 = ((_e343 + _e101) - 1u);
                                let _e347 = block_nodes.member[_e339];
                                let _e360 = (_e339 + 1u);
                                let _e364 = block_nodes.member[select(_e360, _e345, (_e345 < _e360))];
                                let _e377 = (_e339 + 2u);
                                let _e381 = block_nodes.member[select(_e377, _e345, (_e345 < _e377))];
                                let _e394 = (_e339 + 3u);
                                let _e398 = block_nodes.member[select(_e394, _e345, (_e345 < _e394))];
                                let _e412 = select(_e364.member.x, _e347.member.x, (_e347.member.x < _e364.member.x));
                                let _e414 = select(_e364.member.y, _e347.member.y, (_e347.member.y < _e364.member.y));
                                let _e416 = select(_e364.member_1.x, _e347.member_1.x, (_e347.member_1.x < _e364.member_1.x));
                                let _e418 = select(_e364.member_1.y, _e347.member_1.y, (_e347.member_1.y > _e364.member_1.y));
                                let _e420 = select(_e364.member_2.x, _e347.member_2.x, (_e347.member_2.x > _e364.member_2.x));
                                let _e422 = select(_e364.member_2.y, _e347.member_2.y, (_e347.member_2.y > _e364.member_2.y));
                                let _e424 = select(_e398.member.x, _e381.member.x, (_e381.member.x < _e398.member.x));
                                let _e426 = select(_e398.member.y, _e381.member.y, (_e381.member.y < _e398.member.y));
                                let _e428 = select(_e398.member_1.x, _e381.member_1.x, (_e381.member_1.x < _e398.member_1.x));
                                let _e430 = select(_e398.member_1.y, _e381.member_1.y, (_e381.member_1.y > _e398.member_1.y));
                                let _e432 = select(_e398.member_2.x, _e381.member_2.x, (_e381.member_2.x > _e398.member_2.x));
                                let _e434 = select(_e398.member_2.y, _e381.member_2.y, (_e381.member_2.y > _e398.member_2.y));
                                let _e436 = select(_e424, _e412, (_e412 < _e424));
                                let _e438 = select(_e426, _e414, (_e414 < _e426));
                                let _e440 = select(_e428, _e416, (_e416 < _e428));
                                let _e442 = select(_e430, _e418, (_e418 > _e430));
                                let _e444 = select(_e432, _e420, (_e420 > _e432));
                                let _e446 = select(_e434, _e422, (_e422 > _e434));
                                phi_598_ = type_29(array<f32, 3>(select(_e436, _e316.member[0], (_e316.member[0] < _e436)), select(_e438, _e316.member[1], (_e316.member[1] < _e438)), select(_e440, _e316.member[2], (_e316.member[2] < _e440))), array<f32, 3>(select(_e442, _e316.member_1[0], (_e316.member_1[0] > _e442)), select(_e444, _e316.member_1[1], (_e316.member_1[1] > _e444)), select(_e446, _e316.member_1[2], (_e316.member_1[2] > _e446))));
                            } else {
                                phi_598_ = type_29();
                            }
                            let _e475 = phi_598_;
                            continue;
                            continuing {
                                phi_594_ = type_9(select(_e314.member, (_e314.member + 1u), _e319), select(_e314.member_1, _e314.member_1, _e319));
                                phi_597_ = _e475;
                                break if !(_e332);
                            }
                        }
                        if _e132 {
                            phi_874_ = (_e124 / 32u);
                        } else {
                            phi_874_ = 0u;
                        }
                        let _e479 = phi_874_;
                        if _e132 {
                            phi_879_ = (_e126 / 32u);
                        } else {
                            phi_879_ = 0u;
                        }
                        let _e482 = phi_879_;
                        let _e965 = local_5;
                        phi_219_ = _e965;
                        phi_221_ = _e482;
                        phi_223_ = _e479;
                    } else {
                        phi_219_ = type_29();
                        phi_221_ = u32();
                        phi_223_ = u32();
                    }
                    let _e484 = phi_219_;
                    let _e486 = phi_221_;
                    let _e488 = phi_223_;
                    continue;
                    continuing {
                        phi_215_ = type_9(select(_e97.member, (_e97.member + 1u), _e106), select(_e97.member_1, _e97.member_1, _e106));
                        phi_218_ = _e484;
                        phi_220_ = _e486;
                        phi_222_ = _e488;
                        break if !(_e119);
                    }
                }
                phi_885_ = type_9(0u, 8u);
                phi_888_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                phi_890_ = (_e86.w + 1u);
                phi_892_ = (_e93 + 1u);
                loop {
                    let _e494 = phi_885_;
                    let _e496 = phi_888_;
                    let _e498 = phi_890_;
                    let _e500 = phi_892_;
                    local_2 = _e496;
                    local_3 = _e496;
                    let _e503 = (_e494.member < _e494.member_1);
                    let _e514 = select(type_9().member_1, _e494.member, _e503);
                    let _e516 = (bitcast<i32>(select(0u, 1u, _e503)) != 0i);
                    if _e516 {
                        let _e517 = (_e500 % 32u);
                        let _e521 = select((_e500 + (32u - _e517)), _e500, (_e517 == 0u));
                        let _e523 = ((_e498 / 32u) * 32u);
                        if (_e521 < _e523) {
                            let _e526 = params.member.member_2.member_2;
                            phi_944_ = (_e514 < _e526);
                        } else {
                            phi_944_ = false;
                        }
                        let _e529 = phi_944_;
                        let _e530 = select(_e498, _e523, _e529);
                        let _e531 = select(_e498, _e521, _e529);
                        let _e532 = (_e531 - _e500);
                        let _e533 = (_e532 / 4u);
                        phi_969_ = type_9(0u, select(_e533, (_e533 + 1u), ((_e532 % 4u) > 0u)));
                        phi_972_ = _e496;
                        loop {
                            let _e540 = phi_969_;
                            let _e542 = phi_972_;
                            local_6 = _e542;
                            let _e545 = (_e540.member < _e540.member_1);
                            let _e558 = (bitcast<i32>(select(0u, 1u, _e545)) != 0i);
                            if _e558 {
                                let _e564 = params.member.member_2.member[_e514][_e44];
                                let _e565 = (_e564 + (_e500 + (4u * select(type_9().member_1, _e540.member, _e545))));
                                let _e569 = params.member.member_2.member[_e514][_e44];
                                let _e571 = ((_e569 + _e531) - 1u);
                                let _e573 = block_nodes.member[_e565];
                                let _e586 = (_e565 + 1u);
                                let _e590 = block_nodes.member[select(_e586, _e571, (_e571 < _e586))];
                                let _e603 = (_e565 + 2u);
                                let _e607 = block_nodes.member[select(_e603, _e571, (_e571 < _e603))];
                                let _e620 = (_e565 + 3u);
                                let _e624 = block_nodes.member[select(_e620, _e571, (_e571 < _e620))];
                                let _e638 = select(_e590.member.x, _e573.member.x, (_e573.member.x < _e590.member.x));
                                let _e640 = select(_e590.member.y, _e573.member.y, (_e573.member.y < _e590.member.y));
                                let _e642 = select(_e590.member_1.x, _e573.member_1.x, (_e573.member_1.x < _e590.member_1.x));
                                let _e644 = select(_e590.member_1.y, _e573.member_1.y, (_e573.member_1.y > _e590.member_1.y));
                                let _e646 = select(_e590.member_2.x, _e573.member_2.x, (_e573.member_2.x > _e590.member_2.x));
                                let _e648 = select(_e590.member_2.y, _e573.member_2.y, (_e573.member_2.y > _e590.member_2.y));
                                let _e650 = select(_e624.member.x, _e607.member.x, (_e607.member.x < _e624.member.x));
                                let _e652 = select(_e624.member.y, _e607.member.y, (_e607.member.y < _e624.member.y));
                                let _e654 = select(_e624.member_1.x, _e607.member_1.x, (_e607.member_1.x < _e624.member_1.x));
                                let _e656 = select(_e624.member_1.y, _e607.member_1.y, (_e607.member_1.y > _e624.member_1.y));
                                let _e658 = select(_e624.member_2.x, _e607.member_2.x, (_e607.member_2.x > _e624.member_2.x));
                                let _e660 = select(_e624.member_2.y, _e607.member_2.y, (_e607.member_2.y > _e624.member_2.y));
                                let _e662 = select(_e650, _e638, (_e638 < _e650));
                                let _e664 = select(_e652, _e640, (_e640 < _e652));
                                let _e666 = select(_e654, _e642, (_e642 < _e654));
                                let _e668 = select(_e656, _e644, (_e644 > _e656));
                                let _e670 = select(_e658, _e646, (_e646 > _e658));
                                let _e672 = select(_e660, _e648, (_e648 > _e660));
                                phi_973_ = type_29(array<f32, 3>(select(_e662, _e542.member[0], (_e542.member[0] < _e662)), select(_e664, _e542.member[1], (_e542.member[1] < _e664)), select(_e666, _e542.member[2], (_e542.member[2] < _e666))), array<f32, 3>(select(_e668, _e542.member_1[0], (_e542.member_1[0] > _e668)), select(_e670, _e542.member_1[1], (_e542.member_1[1] > _e670)), select(_e672, _e542.member_1[2], (_e542.member_1[2] > _e672))));
                            } else {
                                phi_973_ = type_29();
                            }
                            let _e701 = phi_973_;
                            continue;
                            continuing {
                                phi_969_ = type_9(select(_e540.member, (_e540.member + 1u), _e545), select(_e540.member_1, _e540.member_1, _e545));
                                phi_972_ = _e701;
                                break if !(_e558);
                            }
                        }
                        let _e703 = (_e498 - _e530);
                        let _e704 = (_e703 / 4u);
                        phi_1264_ = type_9(0u, select(_e704, (_e704 + 1u), ((_e703 % 4u) > 0u)));
                        let _e979 = local_6;
                        phi_1267_ = _e979;
                        loop {
                            let _e711 = phi_1264_;
                            let _e713 = phi_1267_;
                            local_7 = _e713;
                            let _e716 = (_e711.member < _e711.member_1);
                            let _e729 = (bitcast<i32>(select(0u, 1u, _e716)) != 0i);
                            if _e729 {
                                let _e735 = params.member.member_2.member[_e514][_e44];
                                let _e736 = (_e735 + (_e530 + (4u * select(type_9().member_1, _e711.member, _e716))));
                                let _e740 = params.member.member_2.member[_e514][_e44];
                                let _e742 = ((_e740 + _e498) - 1u);
                                let _e744 = block_nodes.member[_e736];
                                let _e757 = (_e736 + 1u);
                                let _e761 = block_nodes.member[select(_e757, _e742, (_e742 < _e757))];
                                let _e774 = (_e736 + 2u);
                                let _e778 = block_nodes.member[select(_e774, _e742, (_e742 < _e774))];
                                let _e791 = (_e736 + 3u);
                                let _e795 = block_nodes.member[select(_e791, _e742, (_e742 < _e791))];
                                let _e809 = select(_e761.member.x, _e744.member.x, (_e744.member.x < _e761.member.x));
                                let _e811 = select(_e761.member.y, _e744.member.y, (_e744.member.y < _e761.member.y));
                                let _e813 = select(_e761.member_1.x, _e744.member_1.x, (_e744.member_1.x < _e761.member_1.x));
                                let _e815 = select(_e761.member_1.y, _e744.member_1.y, (_e744.member_1.y > _e761.member_1.y));
                                let _e817 = select(_e761.member_2.x, _e744.member_2.x, (_e744.member_2.x > _e761.member_2.x));
                                let _e819 = select(_e761.member_2.y, _e744.member_2.y, (_e744.member_2.y > _e761.member_2.y));
                                let _e821 = select(_e795.member.x, _e778.member.x, (_e778.member.x < _e795.member.x));
                                let _e823 = select(_e795.member.y, _e778.member.y, (_e778.member.y < _e795.member.y));
                                let _e825 = select(_e795.member_1.x, _e778.member_1.x, (_e778.member_1.x < _e795.member_1.x));
                                let _e827 = select(_e795.member_1.y, _e778.member_1.y, (_e778.member_1.y > _e795.member_1.y));
                                let _e829 = select(_e795.member_2.x, _e778.member_2.x, (_e778.member_2.x > _e795.member_2.x));
                                let _e831 = select(_e795.member_2.y, _e778.member_2.y, (_e778.member_2.y > _e795.member_2.y));
                                let _e833 = select(_e821, _e809, (_e809 < _e821));
                                let _e835 = select(_e823, _e811, (_e811 < _e823));
                                let _e837 = select(_e825, _e813, (_e813 < _e825));
                                let _e839 = select(_e827, _e815, (_e815 > _e827));
                                let _e841 = select(_e829, _e817, (_e817 > _e829));
                                let _e843 = select(_e831, _e819, (_e819 > _e831));
                                phi_1268_ = type_29(array<f32, 3>(select(_e833, _e713.member[0], (_e713.member[0] < _e833)), select(_e835, _e713.member[1], (_e713.member[1] < _e835)), select(_e837, _e713.member[2], (_e713.member[2] < _e837))), array<f32, 3>(select(_e839, _e713.member_1[0], (_e713.member_1[0] > _e839)), select(_e841, _e713.member_1[1], (_e713.member_1[1] > _e841)), select(_e843, _e713.member_1[2], (_e713.member_1[2] > _e843))));
                            } else {
                                phi_1268_ = type_29();
                            }
                            let _e872 = phi_1268_;
                            continue;
                            continuing {
                                phi_1264_ = type_9(select(_e711.member, (_e711.member + 1u), _e716), select(_e711.member_1, _e711.member_1, _e716));
                                phi_1267_ = _e872;
                                break if !(_e729);
                            }
                        }
                        if _e529 {
                            phi_1544_ = (_e521 / 32u);
                        } else {
                            phi_1544_ = 0u;
                        }
                        let _e876 = phi_1544_;
                        if _e529 {
                            phi_1549_ = (_e523 / 32u);
                        } else {
                            phi_1549_ = 0u;
                        }
                        let _e879 = phi_1549_;
                        let _e985 = local_7;
                        phi_889_ = _e985;
                        phi_891_ = _e879;
                        phi_893_ = _e876;
                    } else {
                        phi_889_ = type_29();
                        phi_891_ = u32();
                        phi_893_ = u32();
                    }
                    let _e881 = phi_889_;
                    let _e883 = phi_891_;
                    let _e885 = phi_893_;
                    continue;
                    continuing {
                        phi_885_ = type_9(select(_e494.member, (_e494.member + 1u), _e503), select(_e494.member_1, _e494.member_1, _e503));
                        phi_888_ = _e881;
                        phi_890_ = _e883;
                        phi_892_ = _e885;
                        break if !(_e516);
                    }
                }
                let _e891 = local;
                let _e898 = local_1;
                let _e905 = local_2;
                let _e908 = local_3;
                nodes.member[_e84] = type_25(vec4<u32>(bitcast<u32>(_e891.member[0]), bitcast<u32>(_e891.member[1]), bitcast<u32>(_e891.member[2]), select(_e86.x, ((_e86.x - _e51) | 2147483648u), (_e86.x >= _e51))), vec4<u32>(bitcast<u32>(_e898.member_1[0]), bitcast<u32>(_e898.member_1[1]), bitcast<u32>(_e898.member_1[2]), select(_e86.y, ((_e86.y - _e51) | 2147483648u), (_e86.y >= _e51))), vec4<u32>(bitcast<u32>(_e905.member[0]), bitcast<u32>(_e905.member[1]), bitcast<u32>(_e905.member[2]), _e93), vec4<u32>(bitcast<u32>(_e908.member_1[0]), bitcast<u32>(_e908.member_1[1]), bitcast<u32>(_e908.member_1[2]), (_e86.w | select(0u, 2147483648u, ((_e93 - _e86.z) < (_e86.w - _e93))))));
                phi_1607_ = true;
            }
            let _e943 = phi_1607_;
            phi_1608_ = _e943;
        } else {
            phi_1608_ = false;
        }
        let _e945 = phi_1608_;
        continue;
        continuing {
            phi_142_ = type_9(select(_e62.member, (_e62.member + 1u), _e65), select(_e62.member_1, _e62.member_1, _e65));
            break if !(_e945);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn far_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
