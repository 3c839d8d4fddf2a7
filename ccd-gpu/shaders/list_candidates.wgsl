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
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_23 {
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_36 {
    member: array<vec4<f32>>,
}

struct type_39 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_43 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(3) 
var<storage> ends: type_36;
@group(0) @binding(4) 
var<storage> bodies: type_11;
@group(0) @binding(5) 
var<storage> keys: type_39;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_43;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_1[0] > param[0]), (param_1[1] == param[1])), true, (param_1[1] > param[1]));
    return array<u32, 2>(select(param[0], param_1[0], _e14), select(param[1], param_1[1], _e14));
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_2[0] > param_3[0]), (param_2[1] == param_3[1])), true, (param_2[1] > param_3[1]));
    return array<u32, 2>(select(param_2[0], param_3[0], _e14), select(param_2[1], param_3[1], _e14));
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_5[0] > param_4[0]), (param_5[1] == param_4[1])), true, (param_5[1] > param_4[1]));
    return array<u32, 2>(select(param_4[0], param_5[0], _e14), select(param_4[1], param_5[1], _e14));
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_6[0] > param_7[0]), (param_6[1] == param_7[1])), true, (param_6[1] > param_7[1]));
    return array<u32, 2>(select(param_6[0], param_7[0], _e14), select(param_6[1], param_7[1], _e14));
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_9[0] > param_8[0]), (param_9[1] == param_8[1])), true, (param_9[1] > param_8[1]));
    return array<u32, 2>(select(param_8[0], param_9[0], _e14), select(param_8[1], param_9[1], _e14));
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_10[0] > param_11[0]), (param_10[1] == param_11[1])), true, (param_10[1] > param_11[1]));
    return array<u32, 2>(select(param_10[0], param_11[0], _e14), select(param_10[1], param_11[1], _e14));
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_255_: u32;
    var phi_303_: u32;
    var phi_306_: type_9;
    var phi_380_: u32;
    var phi_666_: bool;
    var phi_704_: type_29;
    var phi_736_: type_9;
    var phi_739_: u32;
    var phi_740_: u32;
    var local: u32;
    var local_1: u32;
    var phi_1057_: type_9;
    var phi_1060_: u32;
    var phi_1061_: u32;
    var phi_1130_: u32;
    var phi_1140_: type_9;
    var phi_1179_: type_9;
    var phi_1182_: type_9;
    var phi_1224_: type_9;
    var phi_1227_: type_9;
    var phi_1284_: type_9;
    var phi_1285_: bool;
    var phi_1225_: type_9;
    var phi_1286_: bool;
    var phi_1297_: type_9;
    var phi_1519_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1609_: bool;
    var phi_1760_: bool;
    var phi_1765_: bool;
    var phi_1929_: bool;
    var phi_1970_: type_15;
    var phi_1973_: u32;
    var phi_1975_: u32;
    var phi_1971_: type_15;
    var phi_2016_: type_16;
    var phi_2092_: bool;
    var phi_2099_: u32;
    var phi_2100_: u32;
    var phi_2101_: bool;
    var phi_1974_: u32;
    var phi_1976_: u32;
    var phi_2102_: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2150_: bool;
    var phi_2151_: bool;
    var phi_2152_: bool;
    var phi_2153_: bool;
    var phi_2158_: bool;
    var phi_2162_: bool;
    var phi_2167_: bool;
    var phi_2172_: bool;
    var phi_2177_: bool;
    var phi_2741_: bool;
    var phi_2742_: bool;
    var phi_2743_: bool;
    var phi_2748_: bool;
    var phi_2749_: bool;
    var phi_2750_: bool;
    var phi_2751_: bool;
    var phi_2775_: bool;
    var phi_2776_: bool;
    var phi_2832_: u32;
    var phi_2839_: type_9;
    var phi_2944_: type_9;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_1183_: type_9;
    var local_4: u32;
    var local_5: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e53 = id_2;
    let _e54 = n_2;
    let _e55 = lane_2;
    let _e68 = ((_e53.y * _e54.x) + _e53.x);
    let _e71 = (_e54.x * _e54.y);
    let _e73 = params.member.member;
    let _e76 = params.member.member_2.member_1;
    let _e82 = params.member.member_1.member_2;
    let _e84 = input.member[0u];
    let _e86 = select(_e84, _e82, (_e82 < _e84));
    if (_e55 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    let _e91 = params.member.member_1.member_1;
    if (_e86 > _e91) {
        let _e95 = params.member.member_1.member_1;
        let _e96 = (_e86 - _e95);
        let _e99 = params.member.member_2.member_3;
        if (_e99 == 0u) {
            return;
        }
        let _e101 = (_e96 / _e99);
        if (_e99 == 0u) {
            return;
        }
        phi_255_ = select(_e101, (_e101 + 1u), ((_e96 % _e99) > 0u));
    } else {
        phi_255_ = 0u;
    }
    let _e108 = phi_255_;
    let _e111 = params.member.member_2.member_4;
    let _e113 = select(_e108, _e111, (_e111 < _e108));
    let _e114 = (_e113 / 4u);
    let _e118 = select(_e114, (_e114 + 1u), ((_e113 % 4u) > 0u));
    if (_e118 > _e68) {
        let _e120 = (_e118 - _e68);
        if (_e71 == 0u) {
            return;
        }
        let _e122 = (_e120 / _e71);
        if (_e71 == 0u) {
            return;
        }
        phi_303_ = select(_e122, (_e122 + 1u), ((_e120 % _e71) > 0u));
    } else {
        phi_303_ = 0u;
    }
    let _e129 = phi_303_;
    phi_306_ = type_9(0u, _e129);
    loop {
        let _e132 = phi_306_;
        let _e135 = (_e132.member < _e132.member_1);
        let _e148 = (bitcast<i32>(select(0u, 1u, _e135)) != 0i);
        if _e148 {
            let _e153 = (((_e68 + (select(type_9().member_1, _e132.member, _e135) * _e71)) * 4u) + (_e55 / 32u));
            let _e156 = params.member.member_1.member_1;
            if (_e86 > _e156) {
                let _e160 = params.member.member_1.member_1;
                let _e161 = (_e86 - _e160);
                let _e164 = params.member.member_2.member_3;
                if (_e164 == 0u) {
                    return;
                }
                let _e166 = (_e161 / _e164);
                if (_e164 == 0u) {
                    return;
                }
                phi_380_ = select(_e166, (_e166 + 1u), ((_e161 % _e164) > 0u));
            } else {
                phi_380_ = 0u;
            }
            let _e173 = phi_380_;
            let _e176 = params.member.member_2.member_4;
            let _e179 = (_e153 < select(_e173, _e176, (_e176 < _e173)));
            let _e182 = params.member.member_1.member_1;
            let _e185 = params.member.member_2.member_3;
            let _e189 = (2u * (_e182 + select(0u, (_e153 * _e185), _e179)));
            let _e192 = input.member[(4u + _e189)];
            let _e195 = input.member[(_e189 + 5u)];
            if (_e55 <= 5u) {
                atomicStore((&counters[_e55]), 0u);
            }
            workgroupBarrier();
            let _e198 = (_e76 == 0u);
            if ((_e55 % 32u) == 0u) {
                let _e204 = (_e55 / 32u);
                let _e210 = params.member.member_2.member[0u][select(1u, 0u, _e198)];
                firsts[(2u * _e204)] = (_e210 + (_e192 * 32u));
                let _e219 = params.member.member_2.member[0u][select(1u, 2u, _e198)];
                firsts[((2u * _e204) + 1u)] = (_e219 + (_e195 * 32u));
            }
            let _e224 = params.member.member_2.member_1;
            let _e225 = (_e224 == 0u);
            let _e226 = select(1u, 0u, _e225);
            let _e227 = select(1u, 2u, _e225);
            let _e228 = (_e55 / 32u);
            let _e229 = (_e55 % 32u);
            let _e231 = params.member.member_2.member_2;
            let _e235 = params.member.member_2.member[_e231][_e226];
            let _e238 = nodes.member[(_e235 + _e192)];
            let _e252 = params.member.member_2.member_2;
            let _e256 = params.member.member_2.member[_e252][_e227];
            let _e259 = nodes.member[(_e256 + _e195)];
            let _e273 = params.member.member_2.member_2;
            let _e280 = params.member.member_2.member[(_e273 - 1u)][_e226];
            let _e283 = nodes.member[(_e280 + ((_e192 * 32u) + _e229))];
            let _e300 = params.member.member_2.member_2;
            let _e307 = params.member.member_2.member[(_e300 - 1u)][_e227];
            let _e310 = nodes.member[(_e307 + ((_e195 * 32u) + _e229))];
            if _e179 {
                phi_666_ = ((((((_e283.member.x <= _e259.member_1.y) && (_e259.member.x <= _e283.member_1.y)) && (_e283.member.y <= _e259.member_2.x)) && (_e259.member.y <= _e283.member_2.x)) && (_e283.member_1.x <= _e259.member_2.y)) && (_e259.member_1.x <= _e283.member_2.y));
            } else {
                phi_666_ = false;
            }
            let _e335 = phi_666_;
            if _e179 {
                if ((((((_e310.member.x <= _e238.member_1.y) && (_e238.member.x <= _e310.member_1.y)) && (_e310.member.y <= _e238.member_2.x)) && (_e238.member.y <= _e310.member_2.x)) && (_e310.member_1.x <= _e238.member_2.y)) && (_e238.member_1.x <= _e310.member_2.y)) {
                    let _e349 = atomicAdd((&counters[_e228]), 1u);
                    let _e350 = ((_e228 * 32u) + _e349);
                    columns[_e350] = type_29(array<f32, 3>(_e310.member.x, _e310.member.y, _e310.member_1.x), array<f32, 3>(_e310.member_1.y, _e310.member_2.x, _e310.member_2.y));
                    names[_e350] = _e229;
                }
            }
            if _e335 {
                phi_704_ = type_29(array<f32, 3>(_e283.member.x, _e283.member.y, _e283.member_1.x), array<f32, 3>(_e283.member_1.y, _e283.member_2.x, _e283.member_2.y));
            } else {
                phi_704_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e357 = phi_704_;
            workgroupBarrier();
            let _e360 = select(false, (_e192 == _e195), (_e76 == 1u));
            let _e361 = (_e55 / 32u);
            let _e363 = (_e361 * 32u);
            let _e365 = atomicLoad((&counters[_e361]));
            let _e366 = (_e365 / 4u);
            phi_736_ = type_9(0u, select(_e366, (_e366 + 1u), ((_e365 % 4u) > 0u)));
            phi_739_ = 0u;
            loop {
                let _e373 = phi_736_;
                let _e375 = phi_739_;
                local = _e375;
                local_1 = _e375;
                let _e378 = (_e373.member < _e373.member_1);
                let _e391 = (bitcast<i32>(select(0u, 1u, _e378)) != 0i);
                if _e391 {
                    let _e392 = (4u * select(type_9().member_1, _e373.member, _e378));
                    let _e395 = columns[(_e363 + _e392)];
                    let _e434 = columns[((_e363 + _e392) + 1u)];
                    let _e475 = columns[((_e363 + _e392) + 2u)];
                    let _e516 = columns[((_e363 + _e392) + 3u)];
                    phi_740_ = (_e375 | ((((select(0u, 1u, ((((((_e357.member[0] <= _e395.member_1[0]) && (_e395.member[0] <= _e357.member_1[0])) && (_e357.member[1] <= _e395.member_1[1])) && (_e395.member[1] <= _e357.member_1[1])) && (_e357.member[2] <= _e395.member_1[2])) && (_e395.member[2] <= _e357.member_1[2]))) << bitcast<u32>((_e392 & 31u))) | (select(0u, 1u, ((((((_e357.member[0] <= _e434.member_1[0]) && (_e434.member[0] <= _e357.member_1[0])) && (_e357.member[1] <= _e434.member_1[1])) && (_e434.member[1] <= _e357.member_1[1])) && (_e357.member[2] <= _e434.member_1[2])) && (_e434.member[2] <= _e357.member_1[2]))) << bitcast<u32>(((_e392 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e357.member[0] <= _e475.member_1[0]) && (_e475.member[0] <= _e357.member_1[0])) && (_e357.member[1] <= _e475.member_1[1])) && (_e475.member[1] <= _e357.member_1[1])) && (_e357.member[2] <= _e475.member_1[2])) && (_e475.member[2] <= _e357.member_1[2]))) << bitcast<u32>(((_e392 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e357.member[0] <= _e516.member_1[0]) && (_e516.member[0] <= _e357.member_1[0])) && (_e357.member[1] <= _e516.member_1[1])) && (_e516.member[1] <= _e357.member_1[1])) && (_e357.member[2] <= _e516.member_1[2])) && (_e516.member[2] <= _e357.member_1[2]))) << bitcast<u32>(((_e392 + 3u) & 31u)))));
                } else {
                    phi_740_ = u32();
                }
                let _e556 = phi_740_;
                continue;
                continuing {
                    phi_736_ = type_9(select(_e373.member, (_e373.member + 1u), _e378), select(_e373.member_1, _e373.member_1, _e378));
                    phi_739_ = _e556;
                    break if !(_e391);
                }
            }
            let _e564 = local;
            let _e567 = local_1;
            let _e568 = select(_e567, (_e564 & ((1u << bitcast<u32>((_e365 & 31u))) - 1u)), (_e365 < 32u));
            if _e360 {
                phi_1057_ = type_9(0u, _e365);
                phi_1060_ = _e568;
                loop {
                    let _e571 = phi_1057_;
                    let _e573 = phi_1060_;
                    local_4 = _e573;
                    let _e576 = (_e571.member < _e571.member_1);
                    let _e587 = select(type_9().member_1, _e571.member, _e576);
                    let _e589 = (bitcast<i32>(select(0u, 1u, _e576)) != 0i);
                    if _e589 {
                        let _e592 = names[(_e363 + _e587)];
                        let _e593 = ((_e55 % 32u) < _e592);
                        phi_1061_ = select(_e573, (_e573 & ~((1u << bitcast<u32>((_e587 & 31u))))), select(true, false, select(select(bool(), select(false, bool(), _e593), _e360), true, select(true, _e593, _e360))));
                    } else {
                        phi_1061_ = u32();
                    }
                    let _e606 = phi_1061_;
                    continue;
                    continuing {
                        phi_1057_ = type_9(select(_e571.member, (_e571.member + 1u), _e576), select(_e571.member_1, _e571.member_1, _e576));
                        phi_1060_ = _e606;
                        break if !(_e589);
                    }
                }
                let _e1641 = local_4;
                phi_1130_ = _e1641;
            } else {
                phi_1130_ = _e568;
            }
            let _e609 = phi_1130_;
            let _e611 = countOneBits(_e609);
            if (_e611 > 0u) {
                let _e614 = atomicAdd((&counters[4u]), _e611);
                phi_1140_ = type_9(_e609, _e614);
            } else {
                phi_1140_ = type_9(_e609, 0u);
            }
            let _e617 = phi_1140_;
            workgroupBarrier();
            if (_e55 == 0u) {
                let _e620 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e620;
            }
            let _e623 = workgroupUniformLoad((&n_hits[0u]));
            let _e624 = (_e623 / 512u);
            if (_e55 == 0u) {
                let _e631 = atomicLoad((&counters[7u]));
                let _e633 = n_hits[0u];
                atomicStore((&counters[7u]), (_e631 + _e633));
            }
            phi_1179_ = type_9(0u, select(_e624, (_e624 + 1u), ((_e623 % 512u) > 0u)));
            phi_1182_ = _e617;
            loop {
                let _e638 = phi_1179_;
                let _e640 = phi_1182_;
                let _e643 = (_e638.member < _e638.member_1);
                let _e656 = (bitcast<i32>(select(0u, 1u, _e643)) != 0i);
                if _e656 {
                    let _e657 = (_e55 / 32u);
                    let _e659 = (select(type_9().member_1, _e638.member, _e643) * 512u);
                    phi_1224_ = _e640;
                    phi_1227_ = type_9(0u, countOneBits(_e640.member));
                    loop {
                        let _e664 = phi_1224_;
                        let _e666 = phi_1227_;
                        local_5 = _e664;
                        let _e669 = (_e666.member < _e666.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e669)) != 0i) {
                            let _e682 = (_e664.member_1 - _e659);
                            if (_e682 >= 512u) {
                                phi_1284_ = type_9();
                                phi_1285_ = false;
                            } else {
                                let _e691 = names[((_e657 * 32u) + select(firstTrailingBit(_e664.member), 32u, (_e664.member == 0u)))];
                                hits[_e682] = (((_e657 << bitcast<u32>(10i)) | ((_e55 % 32u) << bitcast<u32>(5i))) | _e691);
                                phi_1284_ = type_9((_e664.member & (_e664.member - 1u)), (_e664.member_1 + 1u));
                                phi_1285_ = true;
                            }
                            let _e707 = phi_1284_;
                            let _e709 = phi_1285_;
                            phi_1225_ = _e707;
                            phi_1286_ = _e709;
                        } else {
                            phi_1225_ = type_9();
                            phi_1286_ = false;
                        }
                        let _e711 = phi_1225_;
                        let _e713 = phi_1286_;
                        continue;
                        continuing {
                            phi_1224_ = _e711;
                            phi_1227_ = type_9(select(_e666.member, (_e666.member + 1u), _e669), select(_e666.member_1, _e666.member_1, _e669));
                            break if !(_e713);
                        }
                    }
                    workgroupBarrier();
                    let _e716 = n_hits[0u];
                    let _e717 = (_e716 - _e659);
                    let _e719 = select(_e717, 512u, (512u < _e717));
                    phi_1297_ = type_9(0u, 4u);
                    loop {
                        let _e721 = phi_1297_;
                        let _e724 = (_e721.member < _e721.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e724)) != 0i) {
                            let _e739 = (_e55 + (select(type_9().member_1, _e721.member, _e724) * 128u));
                            if (_e739 >= _e719) {
                                phi_2775_ = false;
                            } else {
                                let _e742 = hits[_e739];
                                if ((_e73.member_1 & 512u) != 0u) {
                                    let _e745 = ((_e742 >> bitcast<u32>(10i)) & 3u);
                                    let _e752 = firsts[(2u * _e745)];
                                    let _e753 = (_e752 + ((_e742 >> bitcast<u32>(5i)) & 31u));
                                    let _e757 = firsts[((2u * _e745) + 1u)];
                                    let _e758 = (_e757 + (_e742 & 31u));
                                    let _e764 = ends.member[(((_e753 / 32u) * 96u) + (_e753 % 32u))];
                                    let _e772 = ends.member[(((((_e753 / 32u) * 3u) + 1u) * 32u) + (_e753 % 32u))];
                                    let _e788 = ends.member[(((((_e753 / 32u) * 3u) + 2u) * 32u) + (_e753 % 32u))];
                                    let _e798 = ends.member[(((_e758 / 32u) * 96u) + (_e758 % 32u))];
                                    let _e806 = ends.member[(((((_e758 / 32u) * 3u) + 1u) * 32u) + (_e758 % 32u))];
                                    let _e822 = ends.member[(((((_e758 / 32u) * 3u) + 2u) * 32u) + (_e758 % 32u))];
                                    let _e833 = (((_e73.member_5 + (2f * _e73.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                                    phi_1519_ = !(((((((_e764.x - _e798.w) > _e833) && ((_e772.z - _e822.y) > _e833)) || (((_e798.x - _e764.w) > _e833) && ((_e806.z - _e788.y) > _e833))) || ((((_e764.y - _e806.x) > _e833) && ((_e772.w - _e822.z) > _e833)) || (((_e798.y - _e772.x) > _e833) && ((_e806.w - _e788.z) > _e833)))) || ((((_e764.z - _e806.y) > _e833) && ((_e788.x - _e822.w) > _e833)) || (((_e798.z - _e772.y) > _e833) && ((_e822.x - _e788.w) > _e833)))));
                                } else {
                                    phi_1519_ = true;
                                }
                                let _e871 = phi_1519_;
                                if _e871 {
                                    phi_1609_ = true;
                                } else {
                                    let _e874 = ((_e742 >> bitcast<u32>(10i)) & 3u);
                                    let _e881 = firsts[(2u * _e874)];
                                    let _e886 = firsts[((2u * _e874) + 1u)];
                                    if ((_e73.member_1 & 2u) != 0u) {
                                        phi_1604_ = false;
                                    } else {
                                        if ((_e73.member_1 & 32u) != 0u) {
                                            let _e895 = nodes.member[(_e881 + ((_e742 >> bitcast<u32>(5i)) & 31u))];
                                            let _e909 = nodes.member[(_e886 + (_e742 & 31u))];
                                            phi_1603_ = (((((_e895.member_1.y - _e909.member.x) > _e73.member_6) && ((_e909.member_1.y - _e895.member.x) > _e73.member_6)) && (((_e895.member_2.x - _e909.member.y) > _e73.member_6) && ((_e909.member_2.x - _e895.member.y) > _e73.member_6))) && (((_e895.member_2.y - _e909.member_1.x) > _e73.member_6) && ((_e909.member_2.y - _e895.member_1.x) > _e73.member_6)));
                                        } else {
                                            phi_1603_ = true;
                                        }
                                        let _e941 = phi_1603_;
                                        phi_1604_ = _e941;
                                    }
                                    let _e943 = phi_1604_;
                                    phi_1609_ = select(true, false, _e943);
                                }
                                let _e946 = phi_1609_;
                                if _e946 {
                                    let _e949 = ((_e742 >> bitcast<u32>(10i)) & 3u);
                                    let _e956 = firsts[(2u * _e949)];
                                    let _e961 = firsts[((2u * _e949) + 1u)];
                                    let _e964 = leaves.member[(_e956 + ((_e742 >> bitcast<u32>(5i)) & 31u))];
                                    let _e970 = leaves.member[(_e961 + (_e742 & 31u))];
                                    let _e977 = ((_e742 >> bitcast<u32>(10i)) & 3u);
                                    let _e984 = firsts[(2u * _e977)];
                                    let _e989 = firsts[((2u * _e977) + 1u)];
                                    let _e992 = nodes.member[(_e984 + ((_e742 >> bitcast<u32>(5i)) & 31u))];
                                    let _e1006 = nodes.member[(_e989 + (_e742 & 31u))];
                                    if ((_e73.member_1 & 1u) != 0u) {
                                        if (_e76 == 0u) {
                                            phi_1760_ = ((select((_e970.x == _e964.x), true, (_e970.x == _e964.x)) || select((_e970.y == _e964.x), true, (_e970.y == _e964.x))) || select((_e970.z == _e964.x), true, (_e970.z == _e964.x)));
                                        } else {
                                            phi_1760_ = (select((_e970.x == _e964.y), true, (_e970.x == _e964.x)) || select((_e970.y == _e964.y), true, (_e970.y == _e964.x)));
                                        }
                                        let _e1042 = phi_1760_;
                                        phi_1765_ = select(true, false, _e1042);
                                    } else {
                                        phi_1765_ = true;
                                    }
                                    let _e1045 = phi_1765_;
                                    if _e1045 {
                                        if ((_e73.member_1 & 2u) != 0u) {
                                            let _e1050 = bodies.member[_e964.x];
                                            let _e1052 = bodies.member[_e970.x];
                                            if select(false, (((_e1050 & _e1052) & 1u) == 0u), select(select(true, false, ((_e1050 & 2u) == 0u)), true, ((_e1050 / 4u) != (_e1052 / 4u)))) {
                                                if ((_e73.member_1 & 4u) != 0u) {
                                                    let _e1070 = bodies.member[_e73.member[0]];
                                                    let _e1073 = bodies.member[(_e73.member[0] + 1u)];
                                                    let _e1078 = ((_e73.member[0] + 4u) + (2u * (_e1050 >> bitcast<u32>(2i))));
                                                    let _e1083 = ((_e73.member[0] + 4u) + (2u * (_e1052 >> bitcast<u32>(2i))));
                                                    let _e1085 = bodies.member[_e1078];
                                                    let _e1087 = bodies.member[_e1083];
                                                    let _e1096 = bodies.member[((((_e73.member[0] + 4u) + (2u * _e1070)) + (_e1085 * _e1073)) + (_e1087 / 32u))];
                                                    let _e1099 = bodies.member[(_e1078 + 1u)];
                                                    let _e1102 = bodies.member[(_e1083 + 1u)];
                                                    if (_e1099 == _e1102) {
                                                        phi_1929_ = select(((_e1050 >> bitcast<u32>(2i)) == (_e1052 >> bitcast<u32>(2i))), true, (((_e1096 >> bitcast<u32>(((_e1087 % 32u) & 31u))) & 1u) == 1u));
                                                    } else {
                                                        phi_1929_ = false;
                                                    }
                                                    let _e1117 = phi_1929_;
                                                    if _e1117 {
                                                        let _e1120 = bodies.member[(_e73.member[0] + 2u)];
                                                        let _e1123 = bodies.member[(_e73.member[0] + 3u)];
                                                        let _e1124 = (_e1123 + _e73.member[0]);
                                                        let _e1125 = (_e76 == 1u);
                                                        let _e1126 = (_e970.w < _e964.w);
                                                        let _e1129 = select(_e970.w, select(_e970.w, _e964.w, _e1126), _e1125);
                                                        let _e1130 = select(_e964.w, select(_e964.w, _e970.w, _e1126), _e1125);
                                                        phi_1970_ = type_15(0i, 32i);
                                                        phi_1973_ = _e1120;
                                                        phi_1975_ = 0u;
                                                        loop {
                                                            let _e1132 = phi_1970_;
                                                            let _e1134 = phi_1973_;
                                                            let _e1136 = phi_1975_;
                                                            local_2 = _e1136;
                                                            local_3 = _e1136;
                                                            if (_e1132.member < _e1132.member_1) {
                                                                let _e1143 = (_e1132.member + 1i);
                                                                phi_1971_ = type_15(select(_e1143, type_16().member_1, select(false, true, ((false == (_e1143 > _e1132.member)) != false))), _e1132.member_1);
                                                                phi_2016_ = type_16(1u, _e1132.member);
                                                            } else {
                                                                phi_1971_ = _e1132;
                                                                phi_2016_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e1154 = phi_1971_;
                                                            let _e1156 = phi_2016_;
                                                            if (bitcast<i32>(_e1156.member) != 0i) {
                                                                if (_e1136 >= _e1134) {
                                                                    phi_2099_ = u32();
                                                                    phi_2100_ = u32();
                                                                    phi_2101_ = false;
                                                                } else {
                                                                    let _e1163 = (_e1136 + ((_e1134 - _e1136) / 2u));
                                                                    let _e1165 = (_e1124 + (3u * _e1163));
                                                                    let _e1167 = bodies.member[_e1165];
                                                                    let _e1170 = bodies.member[(_e1165 + 1u)];
                                                                    let _e1173 = bodies.member[(_e1165 + 2u)];
                                                                    if (_e1167 < _e76) {
                                                                        phi_2092_ = true;
                                                                    } else {
                                                                        phi_2092_ = select(true, false, select(true, select(select(true, select(true, false, (_e1173 < _e1129)), (_e1170 == _e1130)), false, (_e1170 < _e1130)), (_e1167 == _e76)));
                                                                    }
                                                                    let _e1185 = phi_2092_;
                                                                    phi_2099_ = select(_e1163, _e1134, _e1185);
                                                                    phi_2100_ = select(_e1136, (_e1163 + 1u), _e1185);
                                                                    phi_2101_ = true;
                                                                }
                                                                let _e1190 = phi_2099_;
                                                                let _e1192 = phi_2100_;
                                                                let _e1194 = phi_2101_;
                                                                phi_1974_ = _e1190;
                                                                phi_1976_ = _e1192;
                                                                phi_2102_ = _e1194;
                                                            } else {
                                                                phi_1974_ = u32();
                                                                phi_1976_ = u32();
                                                                phi_2102_ = false;
                                                            }
                                                            let _e1196 = phi_1974_;
                                                            let _e1198 = phi_1976_;
                                                            let _e1200 = phi_2102_;
                                                            continue;
                                                            continuing {
                                                                phi_1970_ = _e1154;
                                                                phi_1973_ = _e1196;
                                                                phi_1975_ = _e1198;
                                                                break if !(_e1200);
                                                            }
                                                        }
                                                        let _e1203 = local_2;
                                                        if (_e1203 < _e1120) {
                                                            let _e1206 = local_3;
                                                            let _e1208 = (_e1124 + (3u * _e1206));
                                                            let _e1210 = bodies.member[_e1208];
                                                            if (_e1210 == _e76) {
                                                                let _e1214 = bodies.member[(_e1208 + 1u)];
                                                                if (_e1214 == _e1130) {
                                                                    let _e1218 = bodies.member[(_e1208 + 2u)];
                                                                    phi_2150_ = (_e1218 == _e1129);
                                                                    phi_2151_ = false;
                                                                } else {
                                                                    phi_2150_ = bool();
                                                                    phi_2151_ = true;
                                                                }
                                                                let _e1221 = phi_2150_;
                                                                let _e1223 = phi_2151_;
                                                                phi_2152_ = _e1221;
                                                                phi_2153_ = _e1223;
                                                            } else {
                                                                phi_2152_ = bool();
                                                                phi_2153_ = true;
                                                            }
                                                            let _e1225 = phi_2152_;
                                                            let _e1227 = phi_2153_;
                                                            phi_2158_ = select(_e1225, false, _e1227);
                                                        } else {
                                                            phi_2158_ = false;
                                                        }
                                                        let _e1230 = phi_2158_;
                                                        phi_2162_ = _e1230;
                                                    } else {
                                                        phi_2162_ = true;
                                                    }
                                                    let _e1232 = phi_2162_;
                                                    phi_2167_ = select(true, false, _e1232);
                                                } else {
                                                    phi_2167_ = true;
                                                }
                                                let _e1235 = phi_2167_;
                                                phi_2172_ = select(true, false, _e1235);
                                            } else {
                                                phi_2172_ = true;
                                            }
                                            let _e1238 = phi_2172_;
                                            phi_2177_ = select(true, false, _e1238);
                                        } else {
                                            phi_2177_ = true;
                                        }
                                        let _e1241 = phi_2177_;
                                        if _e1241 {
                                            if ((_e73.member_1 & 32u) != 0u) {
                                                let _e1262 = (((((_e992.member_1.y - _e1006.member.x) > _e73.member_6) && ((_e1006.member_1.y - _e992.member.x) > _e73.member_6)) && (((_e992.member_2.x - _e1006.member.y) > _e73.member_6) && ((_e1006.member_2.x - _e992.member.y) > _e73.member_6))) && (((_e992.member_2.y - _e1006.member_1.x) > _e73.member_6) && ((_e1006.member_2.y - _e992.member_1.x) > _e73.member_6)));
                                                if _e1262 {
                                                    phi_2741_ = bool();
                                                } else {
                                                    let _e1264 = keys.member[_e964.x];
                                                    let _e1267 = keys.member[_e964.y];
                                                    let _e1269 = function_5(_e1264[0], _e1267[0]);
                                                    let _e1271 = keys.member[_e964.z];
                                                    let _e1273 = function_5(_e1269, _e1271[0]);
                                                    let _e1275 = keys.member[_e970.x];
                                                    let _e1278 = keys.member[_e970.y];
                                                    let _e1280 = function_4(_e1275[3], _e1278[3]);
                                                    let _e1282 = keys.member[_e970.z];
                                                    let _e1284 = function_4(_e1280, _e1282[3]);
                                                    let _e1298 = keys.member[_e970.x];
                                                    let _e1301 = keys.member[_e970.y];
                                                    let _e1303 = function_5(_e1298[0], _e1301[0]);
                                                    let _e1305 = keys.member[_e970.z];
                                                    let _e1307 = function_5(_e1303, _e1305[0]);
                                                    let _e1309 = keys.member[_e964.x];
                                                    let _e1312 = keys.member[_e964.y];
                                                    let _e1314 = function_4(_e1309[3], _e1312[3]);
                                                    let _e1316 = keys.member[_e964.z];
                                                    let _e1318 = function_4(_e1314, _e1316[3]);
                                                    let _e1333 = keys.member[_e964.x];
                                                    let _e1336 = keys.member[_e964.y];
                                                    let _e1338 = function_3(_e1333[1], _e1336[1]);
                                                    let _e1340 = keys.member[_e964.z];
                                                    let _e1342 = function_3(_e1338, _e1340[1]);
                                                    let _e1344 = keys.member[_e970.x];
                                                    let _e1347 = keys.member[_e970.y];
                                                    let _e1349 = function_2(_e1344[4], _e1347[4]);
                                                    let _e1351 = keys.member[_e970.z];
                                                    let _e1353 = function_2(_e1349, _e1351[4]);
                                                    let _e1367 = keys.member[_e970.x];
                                                    let _e1370 = keys.member[_e970.y];
                                                    let _e1372 = function_3(_e1367[1], _e1370[1]);
                                                    let _e1374 = keys.member[_e970.z];
                                                    let _e1376 = function_3(_e1372, _e1374[1]);
                                                    let _e1378 = keys.member[_e964.x];
                                                    let _e1381 = keys.member[_e964.y];
                                                    let _e1383 = function_2(_e1378[4], _e1381[4]);
                                                    let _e1385 = keys.member[_e964.z];
                                                    let _e1387 = function_2(_e1383, _e1385[4]);
                                                    let _e1403 = keys.member[_e964.x];
                                                    let _e1406 = keys.member[_e964.y];
                                                    let _e1408 = function_1(_e1403[2], _e1406[2]);
                                                    let _e1410 = keys.member[_e964.z];
                                                    let _e1412 = function_1(_e1408, _e1410[2]);
                                                    let _e1414 = keys.member[_e970.x];
                                                    let _e1417 = keys.member[_e970.y];
                                                    let _e1419 = function_(_e1414[5], _e1417[5]);
                                                    let _e1421 = keys.member[_e970.z];
                                                    let _e1423 = function_(_e1419, _e1421[5]);
                                                    let _e1437 = keys.member[_e970.x];
                                                    let _e1440 = keys.member[_e970.y];
                                                    let _e1442 = function_1(_e1437[2], _e1440[2]);
                                                    let _e1444 = keys.member[_e970.z];
                                                    let _e1446 = function_1(_e1442, _e1444[2]);
                                                    let _e1448 = keys.member[_e964.x];
                                                    let _e1451 = keys.member[_e964.y];
                                                    let _e1453 = function_(_e1448[5], _e1451[5]);
                                                    let _e1455 = keys.member[_e964.z];
                                                    let _e1457 = function_(_e1453, _e1455[5]);
                                                    phi_2741_ = (((!(select(select(false, (_e1273[0] > _e1284[0]), (_e1273[1] == _e1284[1])), true, (_e1273[1] > _e1284[1]))) && !(select(select(false, (_e1307[0] > _e1318[0]), (_e1307[1] == _e1318[1])), true, (_e1307[1] > _e1318[1])))) && (!(select(select(false, (_e1342[0] > _e1353[0]), (_e1342[1] == _e1353[1])), true, (_e1342[1] > _e1353[1]))) && !(select(select(false, (_e1376[0] > _e1387[0]), (_e1376[1] == _e1387[1])), true, (_e1376[1] > _e1387[1]))))) && (!(select(select(false, (_e1412[0] > _e1423[0]), (_e1412[1] == _e1423[1])), true, (_e1412[1] > _e1423[1]))) && !(select(select(false, (_e1446[0] > _e1457[0]), (_e1446[1] == _e1457[1])), true, (_e1446[1] > _e1457[1])))));
                                                }
                                                let _e1473 = phi_2741_;
                                                phi_2742_ = _e1473;
                                                phi_2743_ = _e1262;
                                            } else {
                                                phi_2742_ = bool();
                                                phi_2743_ = true;
                                            }
                                            let _e1475 = phi_2742_;
                                            let _e1477 = phi_2743_;
                                            phi_2748_ = _e1475;
                                            phi_2749_ = select(true, false, _e1477);
                                        } else {
                                            phi_2748_ = false;
                                            phi_2749_ = true;
                                        }
                                        let _e1480 = phi_2748_;
                                        let _e1482 = phi_2749_;
                                        phi_2750_ = _e1480;
                                        phi_2751_ = _e1482;
                                    } else {
                                        phi_2750_ = false;
                                        phi_2751_ = true;
                                    }
                                    let _e1484 = phi_2750_;
                                    let _e1486 = phi_2751_;
                                    let _e1487 = select(true, _e1484, _e1486);
                                    if _e1487 {
                                    } else {
                                        let _e1489 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    if _e1487 {
                                        if _e871 {
                                            let _e1491 = atomicAdd((&counters[5u]), 1u);
                                            hits[_e739] = ((2147483648u | (_e1491 << bitcast<u32>(12i))) | _e742);
                                        }
                                    }
                                }
                                phi_2775_ = true;
                            }
                            let _e1498 = phi_2775_;
                            phi_2776_ = _e1498;
                        } else {
                            phi_2776_ = false;
                        }
                        let _e1500 = phi_2776_;
                        continue;
                        continuing {
                            phi_1297_ = type_9(select(_e721.member, (_e721.member + 1u), _e724), select(_e721.member_1, _e721.member_1, _e724));
                            break if !(_e1500);
                        }
                    }
                    let _e1504 = params.member.member_1.member_3;
                    workgroupBarrier();
                    if (_e55 == 0u) {
                        let _e1507 = atomicLoad((&counters[5u]));
                        if (_e1507 > 0u) {
                            let _e1511 = params.member.member.member_1;
                            if ((_e1511 & 1024u) != 0u) {
                                let _e1521 = atomicAdd((&output.member[0u]), _e1507);
                                let _e1522 = (_e1521 + _e1507);
                                let _e1524 = select(_e1522, 4294967295u, (_e1522 < _e1521));
                                let _e1527 = params.member.member_1.member_3;
                                if (_e1524 > _e1527) {
                                    let _e1530 = atomicMax((&output.member[2u]), _e1524);
                                }
                                phi_2832_ = _e1521;
                            } else {
                                let _e1515 = atomicAdd((&output.member[0u]), _e1507);
                                if ((_e1515 + _e1507) < _e1515) {
                                    let _e1519 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2832_ = _e1515;
                            }
                            let _e1532 = phi_2832_;
                            atomicStore((&counters[6u]), _e1532);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1536 = atomicLoad((&counters[6u]));
                    phi_2839_ = type_9(0u, 4u);
                    loop {
                        let _e1538 = phi_2839_;
                        let _e1541 = (_e1538.member < _e1538.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e1541)) != 0i) {
                            let _e1556 = (_e55 + (select(type_9().member_1, _e1538.member, _e1541) * 128u));
                            if (_e1556 >= _e719) {
                                phi_2958_ = false;
                            } else {
                                let _e1559 = hits[_e1556];
                                let _e1565 = select(((_e1559 & 2147483647u) >> bitcast<u32>(12i)), 4294967295u, ((_e1559 & 2147483648u) == 0u));
                                if (_e1565 != 4294967295u) {
                                    let _e1569 = ((_e1559 >> bitcast<u32>(10i)) & 3u);
                                    let _e1576 = firsts[(2u * _e1569)];
                                    let _e1581 = firsts[((2u * _e1569) + 1u)];
                                    let _e1584 = leaves.member[(_e1576 + ((_e1559 >> bitcast<u32>(5i)) & 31u))];
                                    let _e1587 = leaves.member[(_e1581 + (_e1559 & 31u))];
                                    let _e1589 = (_e1536 + _e1565);
                                    if (_e76 == 1u) {
                                        let _e1592 = (_e1584.w < _e1587.w);
                                        phi_2944_ = type_9(select(_e1587.w, _e1584.w, _e1592), select(_e1584.w, _e1587.w, _e1592));
                                    } else {
                                        phi_2944_ = type_9(_e1584.w, _e1587.w);
                                    }
                                    let _e1597 = phi_2944_;
                                    if (_e1589 < _e1504) {
                                        let _e1601 = (2u * _e1589);
                                        atomicStore((&output.member[(4u + _e1601)]), _e1597.member);
                                        atomicStore((&output.member[(_e1601 + 5u)]), _e1597.member_1);
                                    }
                                }
                                phi_2958_ = true;
                            }
                            let _e1607 = phi_2958_;
                            phi_2959_ = _e1607;
                        } else {
                            phi_2959_ = false;
                        }
                        let _e1609 = phi_2959_;
                        continue;
                        continuing {
                            phi_2839_ = type_9(select(_e1538.member, (_e1538.member + 1u), _e1541), select(_e1538.member_1, _e1538.member_1, _e1541));
                            break if !(_e1609);
                        }
                    }
                    workgroupBarrier();
                    let _e1698 = local_5;
                    phi_1183_ = _e1698;
                } else {
                    phi_1183_ = type_9();
                }
                let _e1612 = phi_1183_;
                continue;
                continuing {
                    phi_1179_ = type_9(select(_e638.member, (_e638.member + 1u), _e643), select(_e638.member_1, _e638.member_1, _e643));
                    phi_1182_ = _e1612;
                    break if !(_e656);
                }
            }
        }
        continue;
        continuing {
            phi_306_ = type_9(select(_e132.member, (_e132.member + 1u), _e135), select(_e132.member_1, _e132.member_1, _e135));
            break if !(_e148);
        }
    }
    if (_e55 == 0u) {
        let _e1617 = atomicLoad((&counters[7u]));
        if (_e1617 > 0u) {
            let _e1620 = atomicAdd((&output.member[1u]), _e1617);
            if ((_e1620 + _e1617) < _e1620) {
                let _e1624 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
