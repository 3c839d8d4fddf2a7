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

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_25 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_26 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_30 {
    member: array<atomic<u32>>,
}

var<workgroup> counters: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage, read_write> output: type_30;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(2) 
var<storage> elements: type_11;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_25;
@group(0) @binding(5) 
var<storage> input: type_11;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param[0] > param_1[0]), (param[1] == param_1[1])), true, (param[1] > param_1[1]));
    return array<u32, 2>(select(param[0], param_1[0], _e14), select(param[1], param_1[1], _e14));
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_3[0] > param_2[0]), (param_3[1] == param_2[1])), true, (param_3[1] > param_2[1]));
    return array<u32, 2>(select(param_2[0], param_3[0], _e14), select(param_2[1], param_3[1], _e14));
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_4[0] > param_5[0]), (param_4[1] == param_5[1])), true, (param_4[1] > param_5[1]));
    return array<u32, 2>(select(param_4[0], param_5[0], _e14), select(param_4[1], param_5[1], _e14));
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_7[0] > param_6[0]), (param_7[1] == param_6[1])), true, (param_7[1] > param_6[1]));
    return array<u32, 2>(select(param_6[0], param_7[0], _e14), select(param_6[1], param_7[1], _e14));
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_8[0] > param_9[0]), (param_8[1] == param_9[1])), true, (param_8[1] > param_9[1]));
    return array<u32, 2>(select(param_8[0], param_9[0], _e14), select(param_8[1], param_9[1], _e14));
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_11[0] > param_10[0]), (param_11[1] == param_10[1])), true, (param_11[1] > param_10[1]));
    return array<u32, 2>(select(param_10[0], param_11[0], _e14), select(param_10[1], param_11[1], _e14));
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_291_: u32;
    var phi_336_: u32;
    var phi_339_: type_9;
    var phi_502_: type_26;
    var phi_539_: array<u32, 2>;
    var phi_615_: bool;
    var phi_620_: bool;
    var phi_789_: bool;
    var phi_830_: type_14;
    var phi_833_: u32;
    var phi_835_: u32;
    var phi_831_: type_14;
    var phi_876_: type_15;
    var phi_952_: bool;
    var phi_959_: u32;
    var phi_960_: u32;
    var phi_961_: bool;
    var phi_834_: u32;
    var phi_836_: u32;
    var phi_962_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1018_: bool;
    var phi_1022_: bool;
    var phi_1027_: bool;
    var phi_1032_: bool;
    var phi_1037_: bool;
    var phi_1651_: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1671_: u32;
    var phi_1672_: u32;
    var phi_1673_: bool;
    var phi_1674_: type_9;
    var phi_1724_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e47 = ((_e33.y * _e34.x) + _e33.x);
    let _e50 = (_e34.x * _e34.y);
    let _e54 = params.member.member_2.member;
    let _e56 = params.member.member_1.member_2;
    let _e58 = input.member[0u];
    let _e60 = select(_e58, _e56, (_e56 < _e58));
    let _e62 = params.member.member_1.member_1;
    if (_e60 > _e62) {
        let _e65 = params.member.member_1.member_1;
        phi_291_ = (_e60 - _e65);
    } else {
        phi_291_ = 0u;
    }
    let _e68 = phi_291_;
    let _e70 = params.member.member_1.member;
    let _e72 = select(_e68, _e70, (_e70 < _e68));
    let _e73 = (_e72 / 128u);
    let _e77 = select(_e73, (_e73 + 1u), ((_e72 % 128u) > 0u));
    if (_e77 > _e47) {
        let _e79 = (_e77 - _e47);
        if (_e50 == 0u) {
            return;
        }
        let _e81 = (_e79 / _e50);
        if (_e50 == 0u) {
            return;
        }
        phi_336_ = select(_e81, (_e81 + 1u), ((_e79 % _e50) > 0u));
    } else {
        phi_336_ = 0u;
    }
    let _e88 = phi_336_;
    phi_339_ = type_9(0u, _e88);
    loop {
        let _e91 = phi_339_;
        let _e94 = (_e91.member < _e91.member_1);
        let _e107 = (bitcast<i32>(select(0u, 1u, _e94)) != 0i);
        if _e107 {
            let _e111 = (((_e47 + (select(type_9().member_1, _e91.member, _e94) * _e50)) * 128u) + _e35);
            if (_e35 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if (_e111 < _e72) {
                let _e116 = params.member.member_1.member_1;
                let _e118 = (2u * (_e116 + _e111));
                let _e121 = input.member[(4u + _e118)];
                let _e124 = input.member[(_e118 + 5u)];
                if (_e54 == 0u) {
                    let _e144 = params.member.member.member[1u];
                    let _e147 = ((2u * _e144) + (3u * _e124));
                    let _e149 = elements.member[_e147];
                    let _e152 = elements.member[(_e147 + 1u)];
                    let _e155 = elements.member[(_e147 + 2u)];
                    phi_502_ = type_26(0u, array<u32, 4>(_e121, _e149, _e152, _e155));
                } else {
                    let _e128 = (2u * _e121);
                    let _e130 = elements.member[_e128];
                    let _e133 = elements.member[(_e128 + 1u)];
                    let _e134 = (2u * _e124);
                    let _e136 = elements.member[_e134];
                    let _e139 = elements.member[(_e134 + 1u)];
                    phi_502_ = type_26(1u, array<u32, 4>(_e130, _e133, _e136, _e139));
                }
                let _e159 = phi_502_;
                let _e165 = (_e54 == 0u);
                let _e166 = select(_e159.member_1[2], _e159.member_1[1], _e165);
                let _e167 = select(_e159.member_1[3], _e159.member_1[2], _e165);
                let _e168 = select(_e159.member_1[1], _e159.member_1[0], _e165);
                let _e169 = select(_e159.member_1[1], _e159.member_1[0], _e165);
                if (_e54 == 0u) {
                    let _e183 = params.member.member.member_2[2u];
                    phi_539_ = array<u32, 2>(_e121, (_e183 + _e124));
                } else {
                    let _e174 = params.member.member.member_2[1u];
                    let _e178 = params.member.member.member_2[1u];
                    phi_539_ = array<u32, 2>((_e174 + _e121), (_e178 + _e124));
                }
                let _e187 = phi_539_;
                let _e191 = boxes.member[_e187[0]];
                let _e193 = boxes.member[_e187[1]];
                let _e196 = params.member.member.member_1;
                if ((_e196 & 1u) != 0u) {
                    if (_e54 == 0u) {
                        phi_615_ = ((select((_e166 == _e159.member_1[0]), true, (_e166 == _e159.member_1[0])) || select((_e167 == _e159.member_1[0]), true, (_e167 == _e159.member_1[0]))) || select((_e159.member_1[3] == _e159.member_1[0]), true, (_e159.member_1[3] == _e159.member_1[0])));
                    } else {
                        phi_615_ = (select((_e166 == _e168), true, (_e166 == _e159.member_1[0])) || select((_e167 == _e168), true, (_e167 == _e159.member_1[0])));
                    }
                    let _e219 = phi_615_;
                    phi_620_ = select(true, false, _e219);
                } else {
                    phi_620_ = true;
                }
                let _e222 = phi_620_;
                if _e222 {
                    let _e224 = params.member.member.member_1;
                    if ((_e224 & 2u) != 0u) {
                        let _e228 = bodies.member[_e159.member_1[0]];
                        let _e230 = bodies.member[_e166];
                        if select(false, (((_e228 & _e230) & 1u) == 0u), select(select(true, false, ((_e228 & 2u) == 0u)), true, ((_e228 / 4u) != (_e230 / 4u)))) {
                            let _e243 = params.member.member.member_1;
                            if ((_e243 & 4u) != 0u) {
                                let _e248 = params.member.member.member[0u];
                                let _e250 = bodies.member[_e248];
                                let _e253 = bodies.member[(_e248 + 1u)];
                                let _e258 = ((_e248 + 4u) + (2u * (_e228 >> bitcast<u32>(2i))));
                                let _e263 = ((_e248 + 4u) + (2u * (_e230 >> bitcast<u32>(2i))));
                                let _e265 = bodies.member[_e258];
                                let _e267 = bodies.member[_e263];
                                let _e276 = bodies.member[((((_e248 + 4u) + (2u * _e250)) + (_e265 * _e253)) + (_e267 / 32u))];
                                let _e279 = bodies.member[(_e258 + 1u)];
                                let _e282 = bodies.member[(_e263 + 1u)];
                                if (_e279 == _e282) {
                                    phi_789_ = select(((_e228 >> bitcast<u32>(2i)) == (_e230 >> bitcast<u32>(2i))), true, (((_e276 >> bitcast<u32>(((_e267 % 32u) & 31u))) & 1u) == 1u));
                                } else {
                                    phi_789_ = false;
                                }
                                let _e297 = phi_789_;
                                if _e297 {
                                    let _e300 = bodies.member[(_e248 + 2u)];
                                    let _e303 = bodies.member[(_e248 + 3u)];
                                    let _e304 = (_e303 + _e248);
                                    let _e305 = (_e54 == 1u);
                                    let _e306 = (_e124 < _e121);
                                    let _e309 = select(_e124, select(_e124, _e121, _e306), _e305);
                                    let _e310 = select(_e121, select(_e121, _e124, _e306), _e305);
                                    phi_830_ = type_14(0i, 32i);
                                    phi_833_ = _e300;
                                    phi_835_ = 0u;
                                    loop {
                                        let _e312 = phi_830_;
                                        let _e314 = phi_833_;
                                        let _e316 = phi_835_;
                                        local = _e316;
                                        local_1 = _e316;
                                        if (_e312.member < _e312.member_1) {
                                            let _e323 = (_e312.member + 1i);
                                            phi_831_ = type_14(select(_e323, type_15().member_1, select(false, true, ((false == (_e323 > _e312.member)) != false))), _e312.member_1);
                                            phi_876_ = type_15(1u, _e312.member);
                                        } else {
                                            phi_831_ = _e312;
                                            phi_876_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e334 = phi_831_;
                                        let _e336 = phi_876_;
                                        if (bitcast<i32>(_e336.member) != 0i) {
                                            if (_e316 >= _e314) {
                                                phi_959_ = u32();
                                                phi_960_ = u32();
                                                phi_961_ = false;
                                            } else {
                                                let _e343 = (_e316 + ((_e314 - _e316) / 2u));
                                                let _e345 = (_e304 + (3u * _e343));
                                                let _e347 = bodies.member[_e345];
                                                let _e350 = bodies.member[(_e345 + 1u)];
                                                let _e353 = bodies.member[(_e345 + 2u)];
                                                if (_e347 < _e54) {
                                                    phi_952_ = true;
                                                } else {
                                                    phi_952_ = select(true, false, select(true, select(select(true, select(true, false, (_e353 < _e309)), (_e350 == _e310)), false, (_e350 < _e310)), (_e347 == _e54)));
                                                }
                                                let _e365 = phi_952_;
                                                phi_959_ = select(_e343, _e314, _e365);
                                                phi_960_ = select(_e316, (_e343 + 1u), _e365);
                                                phi_961_ = true;
                                            }
                                            let _e370 = phi_959_;
                                            let _e372 = phi_960_;
                                            let _e374 = phi_961_;
                                            phi_834_ = _e370;
                                            phi_836_ = _e372;
                                            phi_962_ = _e374;
                                        } else {
                                            phi_834_ = u32();
                                            phi_836_ = u32();
                                            phi_962_ = false;
                                        }
                                        let _e376 = phi_834_;
                                        let _e378 = phi_836_;
                                        let _e380 = phi_962_;
                                        continue;
                                        continuing {
                                            phi_830_ = _e334;
                                            phi_833_ = _e376;
                                            phi_835_ = _e378;
                                            break if !(_e380);
                                        }
                                    }
                                    let _e383 = local;
                                    if (_e383 < _e300) {
                                        let _e386 = local_1;
                                        let _e388 = (_e304 + (3u * _e386));
                                        let _e390 = bodies.member[_e388];
                                        if (_e390 == _e54) {
                                            let _e394 = bodies.member[(_e388 + 1u)];
                                            if (_e394 == _e310) {
                                                let _e398 = bodies.member[(_e388 + 2u)];
                                                phi_1010_ = (_e398 == _e309);
                                                phi_1011_ = false;
                                            } else {
                                                phi_1010_ = bool();
                                                phi_1011_ = true;
                                            }
                                            let _e401 = phi_1010_;
                                            let _e403 = phi_1011_;
                                            phi_1012_ = _e401;
                                            phi_1013_ = _e403;
                                        } else {
                                            phi_1012_ = bool();
                                            phi_1013_ = true;
                                        }
                                        let _e405 = phi_1012_;
                                        let _e407 = phi_1013_;
                                        phi_1018_ = select(_e405, false, _e407);
                                    } else {
                                        phi_1018_ = false;
                                    }
                                    let _e410 = phi_1018_;
                                    phi_1022_ = _e410;
                                } else {
                                    phi_1022_ = true;
                                }
                                let _e412 = phi_1022_;
                                phi_1027_ = select(true, false, _e412);
                            } else {
                                phi_1027_ = true;
                            }
                            let _e415 = phi_1027_;
                            phi_1032_ = select(true, false, _e415);
                        } else {
                            phi_1032_ = true;
                        }
                        let _e418 = phi_1032_;
                        phi_1037_ = select(true, false, _e418);
                    } else {
                        phi_1037_ = true;
                    }
                    let _e421 = phi_1037_;
                    if _e421 {
                        let _e423 = params.member.member.member_1;
                        if ((_e423 & 32u) != 0u) {
                            let _e427 = params.member.member.member_6;
                            let _e468 = (((((_e191.member_1[0] - _e193.member[0]) > _e427) && ((_e193.member_1[0] - _e191.member[0]) > _e427)) && (((_e191.member_1[1] - _e193.member[1]) > _e427) && ((_e193.member_1[1] - _e191.member[1]) > _e427))) && (((_e191.member_1[2] - _e193.member[2]) > _e427) && ((_e193.member_1[2] - _e191.member[2]) > _e427)));
                            if _e468 {
                                phi_1651_ = bool();
                            } else {
                                let _e470 = keys.member[_e159.member_1[0]];
                                let _e473 = keys.member[_e168];
                                let _e475 = function_(_e470[0], _e473[0]);
                                let _e477 = keys.member[_e169];
                                let _e479 = function_(_e475, _e477[0]);
                                let _e481 = keys.member[_e166];
                                let _e484 = keys.member[_e167];
                                let _e486 = function_1(_e481[3], _e484[3]);
                                let _e488 = keys.member[_e159.member_1[3]];
                                let _e490 = function_1(_e486, _e488[3]);
                                let _e504 = keys.member[_e166];
                                let _e507 = keys.member[_e167];
                                let _e509 = function_(_e504[0], _e507[0]);
                                let _e511 = keys.member[_e159.member_1[3]];
                                let _e513 = function_(_e509, _e511[0]);
                                let _e515 = keys.member[_e159.member_1[0]];
                                let _e518 = keys.member[_e168];
                                let _e520 = function_1(_e515[3], _e518[3]);
                                let _e522 = keys.member[_e169];
                                let _e524 = function_1(_e520, _e522[3]);
                                let _e539 = keys.member[_e159.member_1[0]];
                                let _e542 = keys.member[_e168];
                                let _e544 = function_2(_e539[1], _e542[1]);
                                let _e546 = keys.member[_e169];
                                let _e548 = function_2(_e544, _e546[1]);
                                let _e550 = keys.member[_e166];
                                let _e553 = keys.member[_e167];
                                let _e555 = function_3(_e550[4], _e553[4]);
                                let _e557 = keys.member[_e159.member_1[3]];
                                let _e559 = function_3(_e555, _e557[4]);
                                let _e573 = keys.member[_e166];
                                let _e576 = keys.member[_e167];
                                let _e578 = function_2(_e573[1], _e576[1]);
                                let _e580 = keys.member[_e159.member_1[3]];
                                let _e582 = function_2(_e578, _e580[1]);
                                let _e584 = keys.member[_e159.member_1[0]];
                                let _e587 = keys.member[_e168];
                                let _e589 = function_3(_e584[4], _e587[4]);
                                let _e591 = keys.member[_e169];
                                let _e593 = function_3(_e589, _e591[4]);
                                let _e609 = keys.member[_e159.member_1[0]];
                                let _e612 = keys.member[_e168];
                                let _e614 = function_4(_e609[2], _e612[2]);
                                let _e616 = keys.member[_e169];
                                let _e618 = function_4(_e614, _e616[2]);
                                let _e620 = keys.member[_e166];
                                let _e623 = keys.member[_e167];
                                let _e625 = function_5(_e620[5], _e623[5]);
                                let _e627 = keys.member[_e159.member_1[3]];
                                let _e629 = function_5(_e625, _e627[5]);
                                let _e643 = keys.member[_e166];
                                let _e646 = keys.member[_e167];
                                let _e648 = function_4(_e643[2], _e646[2]);
                                let _e650 = keys.member[_e159.member_1[3]];
                                let _e652 = function_4(_e648, _e650[2]);
                                let _e654 = keys.member[_e159.member_1[0]];
                                let _e657 = keys.member[_e168];
                                let _e659 = function_5(_e654[5], _e657[5]);
                                let _e661 = keys.member[_e169];
                                let _e663 = function_5(_e659, _e661[5]);
                                phi_1651_ = (((!(select(select(false, (_e479[0] > _e490[0]), (_e479[1] == _e490[1])), true, (_e479[1] > _e490[1]))) && !(select(select(false, (_e513[0] > _e524[0]), (_e513[1] == _e524[1])), true, (_e513[1] > _e524[1])))) && (!(select(select(false, (_e548[0] > _e559[0]), (_e548[1] == _e559[1])), true, (_e548[1] > _e559[1]))) && !(select(select(false, (_e582[0] > _e593[0]), (_e582[1] == _e593[1])), true, (_e582[1] > _e593[1]))))) && (!(select(select(false, (_e618[0] > _e629[0]), (_e618[1] == _e629[1])), true, (_e618[1] > _e629[1]))) && !(select(select(false, (_e652[0] > _e663[0]), (_e652[1] == _e663[1])), true, (_e652[1] > _e663[1])))));
                            }
                            let _e679 = phi_1651_;
                            phi_1652_ = _e679;
                            phi_1653_ = _e468;
                        } else {
                            phi_1652_ = bool();
                            phi_1653_ = true;
                        }
                        let _e681 = phi_1652_;
                        let _e683 = phi_1653_;
                        phi_1658_ = _e681;
                        phi_1659_ = select(true, false, _e683);
                    } else {
                        phi_1658_ = false;
                        phi_1659_ = true;
                    }
                    let _e686 = phi_1658_;
                    let _e688 = phi_1659_;
                    phi_1660_ = _e686;
                    phi_1661_ = _e688;
                } else {
                    phi_1660_ = false;
                    phi_1661_ = true;
                }
                let _e690 = phi_1660_;
                let _e692 = phi_1661_;
                let _e693 = select(true, _e690, _e692);
                if _e693 {
                    let _e695 = atomicAdd((&counters[0u]), 1u);
                    phi_1671_ = _e695;
                } else {
                    phi_1671_ = 0u;
                }
                let _e697 = phi_1671_;
                phi_1672_ = _e697;
                phi_1673_ = _e693;
                phi_1674_ = type_9(_e121, _e124);
            } else {
                phi_1672_ = 0u;
                phi_1673_ = false;
                phi_1674_ = type_9(0u, 0u);
            }
            let _e699 = phi_1672_;
            let _e701 = phi_1673_;
            let _e703 = phi_1674_;
            workgroupBarrier();
            if (_e35 == 0u) {
                let _e706 = atomicLoad((&counters[0u]));
                if (_e706 > 0u) {
                    let _e710 = params.member.member.member_1;
                    if ((_e710 & 1024u) != 0u) {
                        let _e720 = atomicAdd((&output.member[0u]), _e706);
                        let _e721 = (_e720 + _e706);
                        let _e723 = select(_e721, 4294967295u, (_e721 < _e720));
                        let _e726 = params.member.member_1.member_3;
                        if (_e723 > _e726) {
                            let _e729 = atomicMax((&output.member[2u]), _e723);
                        }
                        phi_1724_ = _e720;
                    } else {
                        let _e714 = atomicAdd((&output.member[0u]), _e706);
                        if ((_e714 + _e706) < _e714) {
                            let _e718 = atomicAdd((&output.member[2u]), 1u);
                        }
                        phi_1724_ = _e714;
                    }
                    let _e731 = phi_1724_;
                    atomicStore((&counters[1u]), _e731);
                    let _e734 = atomicAdd((&output.member[1u]), _e706);
                    if ((_e734 + _e706) < _e734) {
                        let _e738 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e701 {
                let _e740 = params.member.member_1.member_3;
                let _e742 = atomicLoad((&counters[1u]));
                let _e743 = (_e742 + _e699);
                if (_e743 < _e740) {
                    let _e747 = (2u * _e743);
                    atomicStore((&output.member[(4u + _e747)]), _e703.member);
                    atomicStore((&output.member[(_e747 + 5u)]), _e703.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_339_ = type_9(select(_e91.member, (_e91.member + 1u), _e94), select(_e91.member_1, _e91.member_1, _e94));
            break if !(_e107);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
