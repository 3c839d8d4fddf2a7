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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> boxes: type_22;
@group(0) @binding(2) 
var<storage, read_write> order: type_11;
var<workgroup> keys: array<vec4<u32>, 256>;
var<workgroup> masks: array<atomic<u32>, 96>;
var<workgroup> boxes_by_bound: array<f32, 1728>;
var<workgroup> merged: array<f32, 248>;

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_24;
    var phi_147_: u32;
    var phi_170_: bool;
    var phi_212_: type_24;
    var phi_213_: u32;
    var phi_256_: u32;
    var phi_290_: u32;
    var phi_324_: u32;
    var phi_332_: type_9;
    var phi_335_: vec4<u32>;
    var phi_336_: vec4<u32>;
    var phi_524_: type_9;
    var phi_527_: vec4<u32>;
    var phi_640_: type_9;
    var phi_643_: u32;
    var phi_644_: u32;
    var local_1: u32;
    var phi_697_: type_9;
    var phi_700_: u32;
    var phi_701_: u32;
    var local_2: u32;
    var phi_754_: type_9;
    var phi_757_: u32;
    var phi_758_: u32;
    var local_3: u32;
    var phi_917_: type_9;
    var phi_920_: type_24;
    var phi_921_: type_24;
    var local_4: type_24;
    var local_5: type_24;
    var local_6: type_24;
    var local_7: type_24;
    var local_8: type_24;
    var local_9: type_24;
    var local_10: type_24;
    var local_11: type_24;
    var local_12: type_24;
    var local_13: type_24;
    var local_14: type_24;
    var local_15: type_24;
    var local_16: type_24;
    var local_17: type_24;
    var phi_1080_: f32;
    var phi_1235_: type_9;
    var phi_1238_: type_24;
    var phi_1239_: type_24;
    var local_18: type_24;
    var local_19: type_24;
    var local_20: type_24;
    var local_21: type_24;
    var local_22: type_24;
    var local_23: type_24;
    var local_24: type_24;
    var local_25: type_24;
    var local_26: type_24;
    var local_27: type_24;
    var local_28: type_24;
    var local_29: type_24;
    var local_30: type_24;
    var local_31: type_24;
    var phi_1398_: f32;
    var phi_1553_: type_9;
    var phi_1556_: type_24;
    var phi_1557_: type_24;
    var local_32: type_24;
    var local_33: type_24;
    var local_34: type_24;
    var local_35: type_24;
    var local_36: type_24;
    var local_37: type_24;
    var local_38: type_24;
    var local_39: type_24;
    var local_40: type_24;
    var local_41: type_24;
    var local_42: type_24;
    var local_43: type_24;
    var local_44: type_24;
    var local_45: type_24;
    var phi_1716_: f32;
    var phi_528_: vec4<u32>;
    var local_46: vec4<u32>;
    var local_47: vec4<u32>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e59 = id_2;
    let _e60 = n_2;
    let _e61 = lane_2;
    let _e71 = ((((_e59.y * _e60.x) + _e59.x) * 256u) + _e61);
    let _e76 = params.member.member_2.member[0u][2u];
    if (_e71 >= _e76) {
        phi_147_ = 2u;
    } else {
        let _e79 = params.member.member_2.member[0u][1u];
        phi_147_ = select(0u, 1u, (_e71 >= _e79));
    }
    let _e83 = phi_147_;
    let _e87 = params.member.member_2.member[0u][_e83];
    let _e88 = (_e71 - _e87);
    let _e92 = params.member.member_2.member[0u][3u];
    if (_e71 < _e92) {
        let _e97 = params.member.member.member[_e83];
        phi_170_ = (_e88 < _e97);
    } else {
        phi_170_ = false;
    }
    let _e100 = phi_170_;
    let _e104 = params.member.member.member_2[_e83];
    let _e105 = (_e104 + _e88);
    if _e100 {
        let _e107 = order.member[_e105];
        let _e109 = boxes.member[_e107];
        phi_212_ = type_24(array<f32, 3>(_e109.member.x, _e109.member.y, _e109.member_1.x), array<f32, 3>(_e109.member_1.y, _e109.member_2.x, _e109.member_2.y));
        phi_213_ = _e107;
    } else {
        phi_212_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_213_ = 0u;
    }
    let _e126 = phi_212_;
    let _e128 = phi_213_;
    local = type_24(array<f32, 3>(_e126.member[0], _e126.member[1], _e126.member[2]), array<f32, 3>(_e126.member_1[0], _e126.member_1[1], _e126.member_1[2]));
    let _e142 = local.member[0u];
    let _e145 = local.member_1[0u];
    if (_e142 <= _e145) {
        let _e150 = bitcast<u32>(((0.5f * _e142) + (0.5f * _e145)));
        phi_256_ = select((_e150 | 2147483648u), ~(_e150), ((_e150 >> bitcast<u32>(31i)) == 1u));
    } else {
        phi_256_ = 4294967295u;
    }
    let _e158 = phi_256_;
    let _e160 = ((_e158 & 4294967040u) | _e61);
    let _e163 = local.member[1u];
    let _e166 = local.member_1[1u];
    if (_e163 <= _e166) {
        let _e171 = bitcast<u32>(((0.5f * _e163) + (0.5f * _e166)));
        phi_290_ = select((_e171 | 2147483648u), ~(_e171), ((_e171 >> bitcast<u32>(31i)) == 1u));
    } else {
        phi_290_ = 4294967295u;
    }
    let _e179 = phi_290_;
    let _e181 = ((_e179 & 4294967040u) | _e61);
    let _e184 = local.member[2u];
    let _e187 = local.member_1[2u];
    if (_e184 <= _e187) {
        let _e192 = bitcast<u32>(((0.5f * _e184) + (0.5f * _e187)));
        phi_324_ = select((_e192 | 2147483648u), ~(_e192), ((_e192 >> bitcast<u32>(31i)) == 1u));
    } else {
        phi_324_ = 4294967295u;
    }
    let _e200 = phi_324_;
    let _e202 = ((_e200 & 4294967040u) | _e61);
    keys[_e61] = vec4<u32>(_e160, _e181, _e202, _e128);
    workgroupBarrier();
    phi_332_ = type_9(0u, 32u);
    phi_335_ = vec4<u32>(0u, 0u, 0u, _e128);
    loop {
        let _e207 = phi_332_;
        let _e209 = phi_335_;
        local_47 = _e209;
        let _e212 = (_e207.member < _e207.member_1);
        let _e223 = select(type_9().member_1, _e207.member, _e212);
        let _e225 = (bitcast<i32>(select(0u, 1u, _e212)) != 0i);
        if _e225 {
            let _e228 = keys[(8u * _e223)];
            let _e232 = keys[((8u * _e223) + 1u)];
            let _e236 = keys[((8u * _e223) + 2u)];
            let _e240 = keys[((8u * _e223) + 3u)];
            let _e244 = keys[((8u * _e223) + 4u)];
            let _e248 = keys[((8u * _e223) + 5u)];
            let _e252 = keys[((8u * _e223) + 6u)];
            let _e256 = keys[((8u * _e223) + 7u)];
            let _e351 = vec4<u32>(((((((((_e209.x + select(0u, 1u, (_e228.x < _e160))) + select(0u, 1u, (_e232.x < _e160))) + select(0u, 1u, (_e236.x < _e160))) + select(0u, 1u, (_e240.x < _e160))) + select(0u, 1u, (_e244.x < _e160))) + select(0u, 1u, (_e248.x < _e160))) + select(0u, 1u, (_e252.x < _e160))) + select(0u, 1u, (_e256.x < _e160))), _e209.y, _e209.z, _e209.w);
            let _e359 = vec4<u32>(_e351.x, ((((((((_e209.y + select(0u, 1u, (_e228.y < _e181))) + select(0u, 1u, (_e232.y < _e181))) + select(0u, 1u, (_e236.y < _e181))) + select(0u, 1u, (_e240.y < _e181))) + select(0u, 1u, (_e244.y < _e181))) + select(0u, 1u, (_e248.y < _e181))) + select(0u, 1u, (_e252.y < _e181))) + select(0u, 1u, (_e256.y < _e181))), _e351.z, _e351.w);
            phi_336_ = vec4<u32>(_e359.x, _e359.y, ((((((((_e209.z + select(0u, 1u, (_e228.z < _e202))) + select(0u, 1u, (_e232.z < _e202))) + select(0u, 1u, (_e236.z < _e202))) + select(0u, 1u, (_e240.z < _e202))) + select(0u, 1u, (_e244.z < _e202))) + select(0u, 1u, (_e248.z < _e202))) + select(0u, 1u, (_e252.z < _e202))) + select(0u, 1u, (_e256.z < _e202))), _e359.w);
        } else {
            phi_336_ = vec4<u32>();
        }
        let _e369 = phi_336_;
        continue;
        continuing {
            phi_332_ = type_9(select(_e207.member, (_e207.member + 1u), _e212), select(_e207.member_1, _e207.member_1, _e212));
            phi_335_ = _e369;
            break if !(_e225);
        }
    }
    phi_524_ = type_9(0u, 3u);
    let _e1491 = local_47;
    phi_527_ = _e1491;
    loop {
        let _e372 = phi_524_;
        let _e374 = phi_527_;
        local_46 = _e374;
        let _e377 = (_e372.member < _e372.member_1);
        let _e388 = select(type_9().member_1, _e372.member, _e377);
        let _e390 = (bitcast<i32>(select(0u, 1u, _e377)) != 0i);
        if _e390 {
            if (_e61 < 96u) {
                atomicStore((&masks[_e61]), 0u);
            }
            workgroupBarrier();
            let _e400 = (_e61 >> bitcast<u32>(((firstLeadingBit(256u) - _e388) & 31u)));
            let _e403 = (_e61 & ~(((256u >> bitcast<u32>((_e388 & 31u))) - 1u)));
            let _e413 = atomicOr((&masks[((_e400 * 8u) + (_e374.x / 32u))]), (1u << bitcast<u32>(((_e374.x % 32u) & 31u))));
            let _e424 = atomicOr((&masks[(((4u + _e400) * 8u) + (_e374.y / 32u))]), (1u << bitcast<u32>(((_e374.y % 32u) & 31u))));
            let _e435 = atomicOr((&masks[(((8u + _e400) * 8u) + (_e374.z / 32u))]), (1u << bitcast<u32>(((_e374.z % 32u) & 31u))));
            workgroupBarrier();
            let _e437 = (_e400 * 8u);
            let _e441 = atomicLoad((&masks[(_e437 + (_e374.x / 32u))]));
            phi_640_ = type_9(0u, (_e374.x / 32u));
            phi_643_ = countOneBits((_e441 & ((1u << bitcast<u32>(((_e374.x % 32u) & 31u))) - 1u)));
            loop {
                let _e452 = phi_640_;
                let _e454 = phi_643_;
                local_1 = _e454;
                let _e457 = (_e452.member < _e452.member_1);
                let _e470 = (bitcast<i32>(select(0u, 1u, _e457)) != 0i);
                if _e470 {
                    let _e473 = atomicLoad((&masks[(_e437 + select(type_9().member_1, _e452.member, _e457))]));
                    phi_644_ = (_e454 + countOneBits(_e473));
                } else {
                    phi_644_ = u32();
                }
                let _e477 = phi_644_;
                continue;
                continuing {
                    phi_640_ = type_9(select(_e452.member, (_e452.member + 1u), _e457), select(_e452.member_1, _e452.member_1, _e457));
                    phi_643_ = _e477;
                    break if !(_e470);
                }
            }
            let _e480 = local_1;
            let _e481 = (_e403 + _e480);
            let _e484 = ((4u + _e400) * 8u);
            let _e488 = atomicLoad((&masks[(_e484 + (_e374.y / 32u))]));
            phi_697_ = type_9(0u, (_e374.y / 32u));
            phi_700_ = countOneBits((_e488 & ((1u << bitcast<u32>(((_e374.y % 32u) & 31u))) - 1u)));
            loop {
                let _e499 = phi_697_;
                let _e501 = phi_700_;
                local_2 = _e501;
                let _e504 = (_e499.member < _e499.member_1);
                let _e517 = (bitcast<i32>(select(0u, 1u, _e504)) != 0i);
                if _e517 {
                    let _e520 = atomicLoad((&masks[(_e484 + select(type_9().member_1, _e499.member, _e504))]));
                    phi_701_ = (_e501 + countOneBits(_e520));
                } else {
                    phi_701_ = u32();
                }
                let _e524 = phi_701_;
                continue;
                continuing {
                    phi_697_ = type_9(select(_e499.member, (_e499.member + 1u), _e504), select(_e499.member_1, _e499.member_1, _e504));
                    phi_700_ = _e524;
                    break if !(_e517);
                }
            }
            let _e527 = local_2;
            let _e528 = (_e403 + _e527);
            let _e531 = ((8u + _e400) * 8u);
            let _e535 = atomicLoad((&masks[(_e531 + (_e374.z / 32u))]));
            phi_754_ = type_9(0u, (_e374.z / 32u));
            phi_757_ = countOneBits((_e535 & ((1u << bitcast<u32>(((_e374.z % 32u) & 31u))) - 1u)));
            loop {
                let _e546 = phi_754_;
                let _e548 = phi_757_;
                local_3 = _e548;
                let _e551 = (_e546.member < _e546.member_1);
                let _e564 = (bitcast<i32>(select(0u, 1u, _e551)) != 0i);
                if _e564 {
                    let _e567 = atomicLoad((&masks[(_e531 + select(type_9().member_1, _e546.member, _e551))]));
                    phi_758_ = (_e548 + countOneBits(_e567));
                } else {
                    phi_758_ = u32();
                }
                let _e571 = phi_758_;
                continue;
                continuing {
                    phi_754_ = type_9(select(_e546.member, (_e546.member + 1u), _e551), select(_e546.member_1, _e546.member_1, _e551));
                    phi_757_ = _e571;
                    break if !(_e564);
                }
            }
            let _e574 = local_3;
            let _e575 = (_e403 + _e574);
            let _e579 = (((_e481 / 32u) * 36u) + (_e481 % 32u));
            let _e582 = local.member[0u];
            boxes_by_bound[_e579] = -(_e582);
            let _e588 = local.member[1u];
            boxes_by_bound[(288u + _e579)] = -(_e588);
            let _e594 = local.member[2u];
            boxes_by_bound[(576u + _e579)] = -(_e594);
            let _e600 = local.member_1[0u];
            boxes_by_bound[(864u + _e579)] = _e600;
            let _e605 = local.member_1[1u];
            boxes_by_bound[(1152u + _e579)] = _e605;
            let _e610 = local.member_1[2u];
            boxes_by_bound[(1440u + _e579)] = _e610;
            workgroupBarrier();
            if (_e61 < 192u) {
                let _e620 = ((((_e61 / 32u) * 288u) + (((_e61 % 32u) / 4u) * 36u)) + (_e61 % 4u));
                let _e622 = boxes_by_bound[_e620];
                let _e625 = boxes_by_bound[(_e620 + 4u)];
                let _e626 = function_(_e622, _e625);
                let _e629 = boxes_by_bound[(_e620 + 8u)];
                let _e632 = boxes_by_bound[(_e620 + 12u)];
                let _e633 = function_(_e629, _e632);
                let _e636 = boxes_by_bound[(_e620 + 16u)];
                let _e639 = boxes_by_bound[(_e620 + 20u)];
                let _e640 = function_(_e636, _e639);
                let _e643 = boxes_by_bound[(_e620 + 24u)];
                let _e646 = boxes_by_bound[(_e620 + 28u)];
                let _e647 = function_(_e643, _e646);
                let _e648 = function_(_e626, _e633);
                let _e649 = function_(_e640, _e647);
                let _e650 = function_(_e648, _e649);
                merged[_e61] = _e650;
            }
            workgroupBarrier();
            if (_e61 < 48u) {
                let _e656 = merged[(4u * _e61)];
                let _e660 = merged[((4u * _e61) + 1u)];
                let _e661 = function_(_e656, _e660);
                let _e665 = merged[((4u * _e61) + 2u)];
                let _e669 = merged[((4u * _e61) + 3u)];
                let _e670 = function_(_e665, _e669);
                let _e671 = function_(_e661, _e670);
                merged[(192u + _e61)] = _e671;
            }
            workgroupBarrier();
            let _e675 = (4u >> bitcast<u32>((_e388 & 31u)));
            if (_e61 < (2u << bitcast<u32>((_e388 & 31u)))) {
                phi_917_ = type_9((_e61 * _e675), ((_e61 + 1u) * _e675));
                phi_920_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                loop {
                    let _e685 = phi_917_;
                    let _e687 = phi_920_;
                    local_4 = _e687;
                    local_5 = _e687;
                    local_6 = _e687;
                    local_7 = _e687;
                    local_8 = _e687;
                    local_9 = _e687;
                    local_10 = _e687;
                    local_11 = _e687;
                    local_12 = _e687;
                    local_13 = _e687;
                    local_14 = _e687;
                    local_15 = _e687;
                    local_16 = _e687;
                    local_17 = _e687;
                    let _e690 = (_e685.member < _e685.member_1);
                    let _e701 = select(type_9().member_1, _e685.member, _e690);
                    let _e703 = (bitcast<i32>(select(0u, 1u, _e690)) != 0i);
                    if _e703 {
                        let _e706 = merged[(192u + _e701)];
                        let _e707 = -(_e706);
                        let _e710 = merged[(200u + _e701)];
                        let _e711 = -(_e710);
                        let _e714 = merged[(208u + _e701)];
                        let _e715 = -(_e714);
                        let _e718 = merged[(216u + _e701)];
                        let _e721 = merged[(224u + _e701)];
                        let _e724 = merged[(232u + _e701)];
                        phi_921_ = type_24(array<f32, 3>(select(_e707, _e687.member[0], (_e687.member[0] < _e707)), select(_e711, _e687.member[1], (_e687.member[1] < _e711)), select(_e715, _e687.member[2], (_e687.member[2] < _e715))), array<f32, 3>(select(_e718, _e687.member_1[0], (_e687.member_1[0] > _e718)), select(_e721, _e687.member_1[1], (_e687.member_1[1] > _e721)), select(_e724, _e687.member_1[2], (_e687.member_1[2] > _e724))));
                    } else {
                        phi_921_ = type_24();
                    }
                    let _e753 = phi_921_;
                    continue;
                    continuing {
                        phi_917_ = type_9(select(_e685.member, (_e685.member + 1u), _e690), select(_e685.member_1, _e685.member_1, _e690));
                        phi_920_ = _e753;
                        break if !(_e703);
                    }
                }
                let _e757 = local_4;
                let _e761 = local_5;
                if (_e757.member[0] <= _e761.member_1[0]) {
                    let _e766 = local_6;
                    let _e770 = local_7;
                    let _e776 = local_8;
                    let _e780 = local_9;
                    let _e785 = (select(_e770.member_1[0], _e766.member_1[0], (_e766.member_1[0] > _e770.member_1[0])) - select(_e780.member[0], _e776.member[0], (_e776.member[0] < _e780.member[0])));
                    let _e787 = local_10;
                    let _e791 = local_11;
                    let _e797 = local_12;
                    let _e801 = local_13;
                    let _e806 = (select(_e791.member_1[1], _e787.member_1[1], (_e787.member_1[1] > _e791.member_1[1])) - select(_e801.member[1], _e797.member[1], (_e797.member[1] < _e801.member[1])));
                    let _e808 = local_14;
                    let _e812 = local_15;
                    let _e818 = local_16;
                    let _e822 = local_17;
                    let _e827 = (select(_e812.member_1[2], _e808.member_1[2], (_e808.member_1[2] > _e812.member_1[2])) - select(_e822.member[2], _e818.member[2], (_e818.member[2] < _e822.member[2])));
                    phi_1080_ = (((_e785 * _e806) + (_e806 * _e827)) + (_e827 * _e785));
                } else {
                    phi_1080_ = 0f;
                }
                let _e834 = phi_1080_;
                merged[(240u + _e61)] = _e834;
            }
            workgroupBarrier();
            let _e841 = (2u * (_e61 >> bitcast<u32>(((firstLeadingBit(256u) - _e388) & 31u))));
            let _e844 = merged[(240u + _e841)];
            let _e847 = merged[(_e841 + 241u)];
            let _e848 = (_e844 + _e847);
            let _e852 = (((_e528 / 32u) * 36u) + (_e528 % 32u));
            let _e855 = local.member[0u];
            boxes_by_bound[_e852] = -(_e855);
            let _e861 = local.member[1u];
            boxes_by_bound[(288u + _e852)] = -(_e861);
            let _e867 = local.member[2u];
            boxes_by_bound[(576u + _e852)] = -(_e867);
            let _e873 = local.member_1[0u];
            boxes_by_bound[(864u + _e852)] = _e873;
            let _e878 = local.member_1[1u];
            boxes_by_bound[(1152u + _e852)] = _e878;
            let _e883 = local.member_1[2u];
            boxes_by_bound[(1440u + _e852)] = _e883;
            workgroupBarrier();
            if (_e61 < 192u) {
                let _e893 = ((((_e61 / 32u) * 288u) + (((_e61 % 32u) / 4u) * 36u)) + (_e61 % 4u));
                let _e895 = boxes_by_bound[_e893];
                let _e898 = boxes_by_bound[(_e893 + 4u)];
                let _e899 = function_(_e895, _e898);
                let _e902 = boxes_by_bound[(_e893 + 8u)];
                let _e905 = boxes_by_bound[(_e893 + 12u)];
                let _e906 = function_(_e902, _e905);
                let _e909 = boxes_by_bound[(_e893 + 16u)];
                let _e912 = boxes_by_bound[(_e893 + 20u)];
                let _e913 = function_(_e909, _e912);
                let _e916 = boxes_by_bound[(_e893 + 24u)];
                let _e919 = boxes_by_bound[(_e893 + 28u)];
                let _e920 = function_(_e916, _e919);
                let _e921 = function_(_e899, _e906);
                let _e922 = function_(_e913, _e920);
                let _e923 = function_(_e921, _e922);
                merged[_e61] = _e923;
            }
            workgroupBarrier();
            if (_e61 < 48u) {
                let _e929 = merged[(4u * _e61)];
                let _e933 = merged[((4u * _e61) + 1u)];
                let _e934 = function_(_e929, _e933);
                let _e938 = merged[((4u * _e61) + 2u)];
                let _e942 = merged[((4u * _e61) + 3u)];
                let _e943 = function_(_e938, _e942);
                let _e944 = function_(_e934, _e943);
                merged[(192u + _e61)] = _e944;
            }
            workgroupBarrier();
            let _e948 = (4u >> bitcast<u32>((_e388 & 31u)));
            if (_e61 < (2u << bitcast<u32>((_e388 & 31u)))) {
                phi_1235_ = type_9((_e61 * _e948), ((_e61 + 1u) * _e948));
                phi_1238_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                loop {
                    let _e958 = phi_1235_;
                    let _e960 = phi_1238_;
                    local_18 = _e960;
                    local_19 = _e960;
                    local_20 = _e960;
                    local_21 = _e960;
                    local_22 = _e960;
                    local_23 = _e960;
                    local_24 = _e960;
                    local_25 = _e960;
                    local_26 = _e960;
                    local_27 = _e960;
                    local_28 = _e960;
                    local_29 = _e960;
                    local_30 = _e960;
                    local_31 = _e960;
                    let _e963 = (_e958.member < _e958.member_1);
                    let _e974 = select(type_9().member_1, _e958.member, _e963);
                    let _e976 = (bitcast<i32>(select(0u, 1u, _e963)) != 0i);
                    if _e976 {
                        let _e979 = merged[(192u + _e974)];
                        let _e980 = -(_e979);
                        let _e983 = merged[(200u + _e974)];
                        let _e984 = -(_e983);
                        let _e987 = merged[(208u + _e974)];
                        let _e988 = -(_e987);
                        let _e991 = merged[(216u + _e974)];
                        let _e994 = merged[(224u + _e974)];
                        let _e997 = merged[(232u + _e974)];
                        phi_1239_ = type_24(array<f32, 3>(select(_e980, _e960.member[0], (_e960.member[0] < _e980)), select(_e984, _e960.member[1], (_e960.member[1] < _e984)), select(_e988, _e960.member[2], (_e960.member[2] < _e988))), array<f32, 3>(select(_e991, _e960.member_1[0], (_e960.member_1[0] > _e991)), select(_e994, _e960.member_1[1], (_e960.member_1[1] > _e994)), select(_e997, _e960.member_1[2], (_e960.member_1[2] > _e997))));
                    } else {
                        phi_1239_ = type_24();
                    }
                    let _e1026 = phi_1239_;
                    continue;
                    continuing {
                        phi_1235_ = type_9(select(_e958.member, (_e958.member + 1u), _e963), select(_e958.member_1, _e958.member_1, _e963));
                        phi_1238_ = _e1026;
                        break if !(_e976);
                    }
                }
                let _e1030 = local_18;
                let _e1034 = local_19;
                if (_e1030.member[0] <= _e1034.member_1[0]) {
                    let _e1039 = local_20;
                    let _e1043 = local_21;
                    let _e1049 = local_22;
                    let _e1053 = local_23;
                    let _e1058 = (select(_e1043.member_1[0], _e1039.member_1[0], (_e1039.member_1[0] > _e1043.member_1[0])) - select(_e1053.member[0], _e1049.member[0], (_e1049.member[0] < _e1053.member[0])));
                    let _e1060 = local_24;
                    let _e1064 = local_25;
                    let _e1070 = local_26;
                    let _e1074 = local_27;
                    let _e1079 = (select(_e1064.member_1[1], _e1060.member_1[1], (_e1060.member_1[1] > _e1064.member_1[1])) - select(_e1074.member[1], _e1070.member[1], (_e1070.member[1] < _e1074.member[1])));
                    let _e1081 = local_28;
                    let _e1085 = local_29;
                    let _e1091 = local_30;
                    let _e1095 = local_31;
                    let _e1100 = (select(_e1085.member_1[2], _e1081.member_1[2], (_e1081.member_1[2] > _e1085.member_1[2])) - select(_e1095.member[2], _e1091.member[2], (_e1091.member[2] < _e1095.member[2])));
                    phi_1398_ = (((_e1058 * _e1079) + (_e1079 * _e1100)) + (_e1100 * _e1058));
                } else {
                    phi_1398_ = 0f;
                }
                let _e1107 = phi_1398_;
                merged[(240u + _e61)] = _e1107;
            }
            workgroupBarrier();
            let _e1114 = (2u * (_e61 >> bitcast<u32>(((firstLeadingBit(256u) - _e388) & 31u))));
            let _e1117 = merged[(240u + _e1114)];
            let _e1120 = merged[(_e1114 + 241u)];
            let _e1121 = (_e1117 + _e1120);
            let _e1125 = (((_e575 / 32u) * 36u) + (_e575 % 32u));
            let _e1128 = local.member[0u];
            boxes_by_bound[_e1125] = -(_e1128);
            let _e1134 = local.member[1u];
            boxes_by_bound[(288u + _e1125)] = -(_e1134);
            let _e1140 = local.member[2u];
            boxes_by_bound[(576u + _e1125)] = -(_e1140);
            let _e1146 = local.member_1[0u];
            boxes_by_bound[(864u + _e1125)] = _e1146;
            let _e1151 = local.member_1[1u];
            boxes_by_bound[(1152u + _e1125)] = _e1151;
            let _e1156 = local.member_1[2u];
            boxes_by_bound[(1440u + _e1125)] = _e1156;
            workgroupBarrier();
            if (_e61 < 192u) {
                let _e1166 = ((((_e61 / 32u) * 288u) + (((_e61 % 32u) / 4u) * 36u)) + (_e61 % 4u));
                let _e1168 = boxes_by_bound[_e1166];
                let _e1171 = boxes_by_bound[(_e1166 + 4u)];
                let _e1172 = function_(_e1168, _e1171);
                let _e1175 = boxes_by_bound[(_e1166 + 8u)];
                let _e1178 = boxes_by_bound[(_e1166 + 12u)];
                let _e1179 = function_(_e1175, _e1178);
                let _e1182 = boxes_by_bound[(_e1166 + 16u)];
                let _e1185 = boxes_by_bound[(_e1166 + 20u)];
                let _e1186 = function_(_e1182, _e1185);
                let _e1189 = boxes_by_bound[(_e1166 + 24u)];
                let _e1192 = boxes_by_bound[(_e1166 + 28u)];
                let _e1193 = function_(_e1189, _e1192);
                let _e1194 = function_(_e1172, _e1179);
                let _e1195 = function_(_e1186, _e1193);
                let _e1196 = function_(_e1194, _e1195);
                merged[_e61] = _e1196;
            }
            workgroupBarrier();
            if (_e61 < 48u) {
                let _e1202 = merged[(4u * _e61)];
                let _e1206 = merged[((4u * _e61) + 1u)];
                let _e1207 = function_(_e1202, _e1206);
                let _e1211 = merged[((4u * _e61) + 2u)];
                let _e1215 = merged[((4u * _e61) + 3u)];
                let _e1216 = function_(_e1211, _e1215);
                let _e1217 = function_(_e1207, _e1216);
                merged[(192u + _e61)] = _e1217;
            }
            workgroupBarrier();
            let _e1221 = (4u >> bitcast<u32>((_e388 & 31u)));
            if (_e61 < (2u << bitcast<u32>((_e388 & 31u)))) {
                phi_1553_ = type_9((_e61 * _e1221), ((_e61 + 1u) * _e1221));
                phi_1556_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                loop {
                    let _e1231 = phi_1553_;
                    let _e1233 = phi_1556_;
                    local_32 = _e1233;
                    local_33 = _e1233;
                    local_34 = _e1233;
                    local_35 = _e1233;
                    local_36 = _e1233;
                    local_37 = _e1233;
                    local_38 = _e1233;
                    local_39 = _e1233;
                    local_40 = _e1233;
                    local_41 = _e1233;
                    local_42 = _e1233;
                    local_43 = _e1233;
                    local_44 = _e1233;
                    local_45 = _e1233;
                    let _e1236 = (_e1231.member < _e1231.member_1);
                    let _e1247 = select(type_9().member_1, _e1231.member, _e1236);
                    let _e1249 = (bitcast<i32>(select(0u, 1u, _e1236)) != 0i);
                    if _e1249 {
                        let _e1252 = merged[(192u + _e1247)];
                        let _e1253 = -(_e1252);
                        let _e1256 = merged[(200u + _e1247)];
                        let _e1257 = -(_e1256);
                        let _e1260 = merged[(208u + _e1247)];
                        let _e1261 = -(_e1260);
                        let _e1264 = merged[(216u + _e1247)];
                        let _e1267 = merged[(224u + _e1247)];
                        let _e1270 = merged[(232u + _e1247)];
                        phi_1557_ = type_24(array<f32, 3>(select(_e1253, _e1233.member[0], (_e1233.member[0] < _e1253)), select(_e1257, _e1233.member[1], (_e1233.member[1] < _e1257)), select(_e1261, _e1233.member[2], (_e1233.member[2] < _e1261))), array<f32, 3>(select(_e1264, _e1233.member_1[0], (_e1233.member_1[0] > _e1264)), select(_e1267, _e1233.member_1[1], (_e1233.member_1[1] > _e1267)), select(_e1270, _e1233.member_1[2], (_e1233.member_1[2] > _e1270))));
                    } else {
                        phi_1557_ = type_24();
                    }
                    let _e1299 = phi_1557_;
                    continue;
                    continuing {
                        phi_1553_ = type_9(select(_e1231.member, (_e1231.member + 1u), _e1236), select(_e1231.member_1, _e1231.member_1, _e1236));
                        phi_1556_ = _e1299;
                        break if !(_e1249);
                    }
                }
                let _e1303 = local_32;
                let _e1307 = local_33;
                if (_e1303.member[0] <= _e1307.member_1[0]) {
                    let _e1312 = local_34;
                    let _e1316 = local_35;
                    let _e1322 = local_36;
                    let _e1326 = local_37;
                    let _e1331 = (select(_e1316.member_1[0], _e1312.member_1[0], (_e1312.member_1[0] > _e1316.member_1[0])) - select(_e1326.member[0], _e1322.member[0], (_e1322.member[0] < _e1326.member[0])));
                    let _e1333 = local_38;
                    let _e1337 = local_39;
                    let _e1343 = local_40;
                    let _e1347 = local_41;
                    let _e1352 = (select(_e1337.member_1[1], _e1333.member_1[1], (_e1333.member_1[1] > _e1337.member_1[1])) - select(_e1347.member[1], _e1343.member[1], (_e1343.member[1] < _e1347.member[1])));
                    let _e1354 = local_42;
                    let _e1358 = local_43;
                    let _e1364 = local_44;
                    let _e1368 = local_45;
                    let _e1373 = (select(_e1358.member_1[2], _e1354.member_1[2], (_e1354.member_1[2] > _e1358.member_1[2])) - select(_e1368.member[2], _e1364.member[2], (_e1364.member[2] < _e1368.member[2])));
                    phi_1716_ = (((_e1331 * _e1352) + (_e1352 * _e1373)) + (_e1373 * _e1331));
                } else {
                    phi_1716_ = 0f;
                }
                let _e1380 = phi_1716_;
                merged[(240u + _e61)] = _e1380;
            }
            workgroupBarrier();
            let _e1387 = (2u * (_e61 >> bitcast<u32>(((firstLeadingBit(256u) - _e388) & 31u))));
            let _e1390 = merged[(240u + _e1387)];
            let _e1393 = merged[(_e1387 + 241u)];
            let _e1394 = (_e1390 + _e1393);
            let _e1400 = select(select(0u, 2u, (_e1394 < _e848)), select(1u, 2u, (_e1394 < _e1121)), (_e1121 < _e848));
            let _e1404 = select(select(_e575, _e528, (_e1400 == 1u)), _e481, (_e1400 == 0u));
            keys[_e1404] = _e374;
            let _e1409 = (((_e1404 / 32u) * 36u) + (_e1404 % 32u));
            let _e1412 = local.member[0u];
            boxes_by_bound[_e1409] = -(_e1412);
            let _e1418 = local.member[1u];
            boxes_by_bound[(288u + _e1409)] = -(_e1418);
            let _e1424 = local.member[2u];
            boxes_by_bound[(576u + _e1409)] = -(_e1424);
            let _e1430 = local.member_1[0u];
            boxes_by_bound[(864u + _e1409)] = _e1430;
            let _e1435 = local.member_1[1u];
            boxes_by_bound[(1152u + _e1409)] = _e1435;
            let _e1440 = local.member_1[2u];
            boxes_by_bound[(1440u + _e1409)] = _e1440;
            workgroupBarrier();
            let _e1443 = keys[_e61];
            let _e1447 = (((_e61 / 32u) * 36u) + (_e61 % 32u));
            let _e1449 = boxes_by_bound[_e1447];
            let _e1453 = boxes_by_bound[(288u + _e1447)];
            let _e1457 = boxes_by_bound[(576u + _e1447)];
            let _e1461 = boxes_by_bound[(864u + _e1447)];
            let _e1464 = boxes_by_bound[(1152u + _e1447)];
            let _e1467 = boxes_by_bound[(1440u + _e1447)];
            local = type_24(array<f32, 3>(-(_e1449), -(_e1453), -(_e1457)), array<f32, 3>(_e1461, _e1464, _e1467));
            phi_528_ = _e1443;
        } else {
            phi_528_ = vec4<u32>();
        }
        let _e1472 = phi_528_;
        continue;
        continuing {
            phi_524_ = type_9(select(_e372.member, (_e372.member + 1u), _e377), select(_e372.member_1, _e372.member_1, _e377));
            phi_527_ = _e1472;
            break if !(_e390);
        }
    }
    let _e1475 = local_46;
    if _e100 {
        order.member[_e105] = _e1475.w;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn halve_runs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
