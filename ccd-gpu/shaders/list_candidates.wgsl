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

struct type_44 {
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
var<storage, read_write> output: type_44;

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
    var phi_252_: u32;
    var phi_300_: u32;
    var phi_303_: type_9;
    var phi_377_: u32;
    var phi_663_: bool;
    var phi_701_: type_29;
    var phi_733_: type_9;
    var phi_736_: u32;
    var phi_737_: u32;
    var local: u32;
    var local_1: u32;
    var phi_1054_: type_9;
    var phi_1057_: u32;
    var phi_1058_: u32;
    var phi_1127_: u32;
    var phi_1169_: type_9;
    var phi_1233_: type_9;
    var phi_1236_: u32;
    var phi_1237_: u32;
    var phi_1356_: type_9;
    var phi_1361_: u32;
    var phi_1584_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1660_: bool;
    var phi_1750_: array<type_29, 2>;
    var phi_1794_: bool;
    var phi_1799_: bool;
    var phi_1963_: bool;
    var phi_2004_: type_15;
    var phi_2007_: u32;
    var phi_2009_: u32;
    var phi_2005_: type_15;
    var phi_2050_: type_16;
    var phi_2126_: bool;
    var phi_2133_: u32;
    var phi_2134_: u32;
    var phi_2135_: bool;
    var phi_2008_: u32;
    var phi_2010_: u32;
    var phi_2136_: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2184_: bool;
    var phi_2185_: bool;
    var phi_2186_: bool;
    var phi_2187_: bool;
    var phi_2192_: bool;
    var phi_2196_: bool;
    var phi_2201_: bool;
    var phi_2206_: bool;
    var phi_2211_: bool;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2794_: bool;
    var phi_2795_: bool;
    var phi_2796_: bool;
    var phi_2797_: bool;
    var phi_2819_: u32;
    var phi_2821_: u32;
    var phi_2822_: bool;
    var phi_1362_: u32;
    var phi_2823_: bool;
    var local_4: u32;
    var phi_2882_: u32;
    var phi_2890_: type_9;
    var phi_2893_: u32;
    var local_5: u32;
    var phi_2991_: type_9;
    var phi_3006_: u32;
    var phi_2894_: u32;
    var local_6: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e66 = ((_e51.y * _e52.x) + _e51.x);
    let _e69 = (_e52.x * _e52.y);
    let _e71 = params.member.member;
    let _e74 = params.member.member_2.member_1;
    let _e80 = params.member.member_1.member_2;
    let _e82 = input.member[0u];
    let _e84 = select(_e82, _e80, (_e80 < _e82));
    if (_e53 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    let _e89 = params.member.member_1.member_1;
    if (_e84 > _e89) {
        let _e93 = params.member.member_1.member_1;
        let _e94 = (_e84 - _e93);
        let _e97 = params.member.member_2.member_3;
        if (_e97 == 0u) {
            return;
        }
        let _e99 = (_e94 / _e97);
        if (_e97 == 0u) {
            return;
        }
        phi_252_ = select(_e99, (_e99 + 1u), ((_e94 % _e97) > 0u));
    } else {
        phi_252_ = 0u;
    }
    let _e106 = phi_252_;
    let _e109 = params.member.member_2.member_4;
    let _e111 = select(_e106, _e109, (_e109 < _e106));
    let _e112 = (_e111 / 4u);
    let _e116 = select(_e112, (_e112 + 1u), ((_e111 % 4u) > 0u));
    if (_e116 > _e66) {
        let _e118 = (_e116 - _e66);
        if (_e69 == 0u) {
            return;
        }
        let _e120 = (_e118 / _e69);
        if (_e69 == 0u) {
            return;
        }
        phi_300_ = select(_e120, (_e120 + 1u), ((_e118 % _e69) > 0u));
    } else {
        phi_300_ = 0u;
    }
    let _e127 = phi_300_;
    phi_303_ = type_9(0u, _e127);
    loop {
        let _e130 = phi_303_;
        let _e133 = (_e130.member < _e130.member_1);
        let _e146 = (bitcast<i32>(select(0u, 1u, _e133)) != 0i);
        if _e146 {
            let _e151 = (((_e66 + (select(type_9().member_1, _e130.member, _e133) * _e69)) * 4u) + (_e53 / 32u));
            let _e154 = params.member.member_1.member_1;
            if (_e84 > _e154) {
                let _e158 = params.member.member_1.member_1;
                let _e159 = (_e84 - _e158);
                let _e162 = params.member.member_2.member_3;
                if (_e162 == 0u) {
                    return;
                }
                let _e164 = (_e159 / _e162);
                if (_e162 == 0u) {
                    return;
                }
                phi_377_ = select(_e164, (_e164 + 1u), ((_e159 % _e162) > 0u));
            } else {
                phi_377_ = 0u;
            }
            let _e171 = phi_377_;
            let _e174 = params.member.member_2.member_4;
            let _e177 = (_e151 < select(_e171, _e174, (_e174 < _e171)));
            let _e180 = params.member.member_1.member_1;
            let _e183 = params.member.member_2.member_3;
            let _e187 = (2u * (_e180 + select(0u, (_e151 * _e183), _e177)));
            let _e190 = input.member[(4u + _e187)];
            let _e193 = input.member[(_e187 + 5u)];
            if (_e53 <= 5u) {
                atomicStore((&counters[_e53]), 0u);
            }
            workgroupBarrier();
            let _e196 = (_e74 == 0u);
            if ((_e53 % 32u) == 0u) {
                let _e202 = (_e53 / 32u);
                let _e208 = params.member.member_2.member[0u][select(1u, 0u, _e196)];
                firsts[(2u * _e202)] = (_e208 + (_e190 * 32u));
                let _e217 = params.member.member_2.member[0u][select(1u, 2u, _e196)];
                firsts[((2u * _e202) + 1u)] = (_e217 + (_e193 * 32u));
            }
            let _e222 = params.member.member_2.member_1;
            let _e223 = (_e222 == 0u);
            let _e224 = select(1u, 0u, _e223);
            let _e225 = select(1u, 2u, _e223);
            let _e226 = (_e53 / 32u);
            let _e227 = (_e53 % 32u);
            let _e229 = params.member.member_2.member_2;
            let _e233 = params.member.member_2.member[_e229][_e224];
            let _e236 = nodes.member[(_e233 + _e190)];
            let _e250 = params.member.member_2.member_2;
            let _e254 = params.member.member_2.member[_e250][_e225];
            let _e257 = nodes.member[(_e254 + _e193)];
            let _e271 = params.member.member_2.member_2;
            let _e278 = params.member.member_2.member[(_e271 - 1u)][_e224];
            let _e281 = nodes.member[(_e278 + ((_e190 * 32u) + _e227))];
            let _e298 = params.member.member_2.member_2;
            let _e305 = params.member.member_2.member[(_e298 - 1u)][_e225];
            let _e308 = nodes.member[(_e305 + ((_e193 * 32u) + _e227))];
            if _e177 {
                phi_663_ = ((((((_e281.member.x <= _e257.member_1.y) && (_e257.member.x <= _e281.member_1.y)) && (_e281.member.y <= _e257.member_2.x)) && (_e257.member.y <= _e281.member_2.x)) && (_e281.member_1.x <= _e257.member_2.y)) && (_e257.member_1.x <= _e281.member_2.y));
            } else {
                phi_663_ = false;
            }
            let _e333 = phi_663_;
            if _e177 {
                if ((((((_e308.member.x <= _e236.member_1.y) && (_e236.member.x <= _e308.member_1.y)) && (_e308.member.y <= _e236.member_2.x)) && (_e236.member.y <= _e308.member_2.x)) && (_e308.member_1.x <= _e236.member_2.y)) && (_e236.member_1.x <= _e308.member_2.y)) {
                    let _e347 = atomicAdd((&counters[_e226]), 1u);
                    let _e348 = ((_e226 * 32u) + _e347);
                    columns[_e348] = type_29(array<f32, 3>(_e308.member.x, _e308.member.y, _e308.member_1.x), array<f32, 3>(_e308.member_1.y, _e308.member_2.x, _e308.member_2.y));
                    names[_e348] = _e227;
                }
            }
            if _e333 {
                phi_701_ = type_29(array<f32, 3>(_e281.member.x, _e281.member.y, _e281.member_1.x), array<f32, 3>(_e281.member_1.y, _e281.member_2.x, _e281.member_2.y));
            } else {
                phi_701_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e355 = phi_701_;
            workgroupBarrier();
            let _e358 = select(false, (_e190 == _e193), (_e74 == 1u));
            let _e359 = (_e53 / 32u);
            let _e361 = (_e359 * 32u);
            let _e363 = atomicLoad((&counters[_e359]));
            let _e364 = (_e363 / 4u);
            phi_733_ = type_9(0u, select(_e364, (_e364 + 1u), ((_e363 % 4u) > 0u)));
            phi_736_ = 0u;
            loop {
                let _e371 = phi_733_;
                let _e373 = phi_736_;
                local = _e373;
                local_1 = _e373;
                let _e376 = (_e371.member < _e371.member_1);
                let _e389 = (bitcast<i32>(select(0u, 1u, _e376)) != 0i);
                if _e389 {
                    let _e390 = (4u * select(type_9().member_1, _e371.member, _e376));
                    let _e393 = columns[(_e361 + _e390)];
                    let _e432 = columns[((_e361 + _e390) + 1u)];
                    let _e473 = columns[((_e361 + _e390) + 2u)];
                    let _e514 = columns[((_e361 + _e390) + 3u)];
                    phi_737_ = (_e373 | ((((select(0u, 1u, ((((((_e355.member[0] <= _e393.member_1[0]) && (_e393.member[0] <= _e355.member_1[0])) && (_e355.member[1] <= _e393.member_1[1])) && (_e393.member[1] <= _e355.member_1[1])) && (_e355.member[2] <= _e393.member_1[2])) && (_e393.member[2] <= _e355.member_1[2]))) << bitcast<u32>((_e390 & 31u))) | (select(0u, 1u, ((((((_e355.member[0] <= _e432.member_1[0]) && (_e432.member[0] <= _e355.member_1[0])) && (_e355.member[1] <= _e432.member_1[1])) && (_e432.member[1] <= _e355.member_1[1])) && (_e355.member[2] <= _e432.member_1[2])) && (_e432.member[2] <= _e355.member_1[2]))) << bitcast<u32>(((_e390 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e355.member[0] <= _e473.member_1[0]) && (_e473.member[0] <= _e355.member_1[0])) && (_e355.member[1] <= _e473.member_1[1])) && (_e473.member[1] <= _e355.member_1[1])) && (_e355.member[2] <= _e473.member_1[2])) && (_e473.member[2] <= _e355.member_1[2]))) << bitcast<u32>(((_e390 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e355.member[0] <= _e514.member_1[0]) && (_e514.member[0] <= _e355.member_1[0])) && (_e355.member[1] <= _e514.member_1[1])) && (_e514.member[1] <= _e355.member_1[1])) && (_e355.member[2] <= _e514.member_1[2])) && (_e514.member[2] <= _e355.member_1[2]))) << bitcast<u32>(((_e390 + 3u) & 31u)))));
                } else {
                    phi_737_ = u32();
                }
                let _e554 = phi_737_;
                continue;
                continuing {
                    phi_733_ = type_9(select(_e371.member, (_e371.member + 1u), _e376), select(_e371.member_1, _e371.member_1, _e376));
                    phi_736_ = _e554;
                    break if !(_e389);
                }
            }
            let _e562 = local;
            let _e565 = local_1;
            let _e566 = select(_e565, (_e562 & ((1u << bitcast<u32>((_e363 & 31u))) - 1u)), (_e363 < 32u));
            if _e358 {
                phi_1054_ = type_9(0u, _e363);
                phi_1057_ = _e566;
                loop {
                    let _e569 = phi_1054_;
                    let _e571 = phi_1057_;
                    local_6 = _e571;
                    let _e574 = (_e569.member < _e569.member_1);
                    let _e585 = select(type_9().member_1, _e569.member, _e574);
                    let _e587 = (bitcast<i32>(select(0u, 1u, _e574)) != 0i);
                    if _e587 {
                        let _e590 = names[(_e361 + _e585)];
                        let _e591 = ((_e53 % 32u) < _e590);
                        phi_1058_ = select(_e571, (_e571 & ~((1u << bitcast<u32>((_e585 & 31u))))), select(true, false, select(select(bool(), select(false, bool(), _e591), _e358), true, select(true, _e591, _e358))));
                    } else {
                        phi_1058_ = u32();
                    }
                    let _e604 = phi_1058_;
                    continue;
                    continuing {
                        phi_1054_ = type_9(select(_e569.member, (_e569.member + 1u), _e574), select(_e569.member_1, _e569.member_1, _e574));
                        phi_1057_ = _e604;
                        break if !(_e587);
                    }
                }
                let _e1681 = local_6;
                phi_1127_ = _e1681;
            } else {
                phi_1127_ = _e566;
            }
            let _e607 = phi_1127_;
            let _e610 = atomicAdd((&counters[4u]), countOneBits(_e607));
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e613 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e613;
            }
            let _e616 = workgroupUniformLoad((&n_hits[0u]));
            let _e617 = (_e616 / 512u);
            if (_e53 == 0u) {
                let _e624 = atomicLoad((&counters[7u]));
                let _e626 = n_hits[0u];
                atomicStore((&counters[7u]), (_e624 + _e626));
            }
            phi_1169_ = type_9(0u, select(_e617, (_e617 + 1u), ((_e616 % 512u) > 0u)));
            loop {
                let _e631 = phi_1169_;
                let _e634 = (_e631.member < _e631.member_1);
                let _e647 = (bitcast<i32>(select(0u, 1u, _e634)) != 0i);
                if _e647 {
                    let _e648 = (_e53 / 32u);
                    let _e654 = ((_e648 << bitcast<u32>(10i)) | ((_e53 % 32u) << bitcast<u32>(5i)));
                    let _e655 = (select(type_9().member_1, _e631.member, _e634) * 512u);
                    let _e658 = atomicLoad((&counters[_e648]));
                    let _e659 = (_e658 / 4u);
                    phi_1233_ = type_9(0u, select(_e659, (_e659 + 1u), ((_e658 % 4u) > 0u)));
                    phi_1236_ = (_e610 - _e655);
                    loop {
                        let _e666 = phi_1233_;
                        let _e668 = phi_1236_;
                        let _e671 = (_e666.member < _e666.member_1);
                        let _e684 = (bitcast<i32>(select(0u, 1u, _e671)) != 0i);
                        if _e684 {
                            let _e685 = (4u * select(type_9().member_1, _e666.member, _e671));
                            let _e691 = (((_e607 >> bitcast<u32>((_e685 & 31u))) & 1u) == 1u);
                            if _e691 {
                                if (_e668 < 512u) {
                                    hits[_e668] = (_e654 + _e685);
                                }
                            }
                            let _e695 = select(_e668, (_e668 + 1u), _e691);
                            let _e703 = (((_e607 >> bitcast<u32>(((_e685 + 1u) & 31u))) & 1u) == 1u);
                            if _e703 {
                                if (_e695 < 512u) {
                                    hits[_e695] = ((_e654 + _e685) + 1u);
                                }
                            }
                            let _e707 = select(_e695, (_e695 + 1u), _e703);
                            let _e715 = (((_e607 >> bitcast<u32>(((_e685 + 2u) & 31u))) & 1u) == 1u);
                            if _e715 {
                                if (_e707 < 512u) {
                                    hits[_e707] = ((_e654 + _e685) + 2u);
                                }
                            }
                            let _e719 = select(_e707, (_e707 + 1u), _e715);
                            let _e727 = (((_e607 >> bitcast<u32>(((_e685 + 3u) & 31u))) & 1u) == 1u);
                            if _e727 {
                                if (_e719 < 512u) {
                                    hits[_e719] = ((_e654 + _e685) + 3u);
                                }
                            }
                            phi_1237_ = select(_e719, (_e719 + 1u), _e727);
                        } else {
                            phi_1237_ = u32();
                        }
                        let _e733 = phi_1237_;
                        continue;
                        continuing {
                            phi_1233_ = type_9(select(_e666.member, (_e666.member + 1u), _e671), select(_e666.member_1, _e666.member_1, _e671));
                            phi_1236_ = _e733;
                            break if !(_e684);
                        }
                    }
                    workgroupBarrier();
                    let _e736 = n_hits[0u];
                    let _e737 = (_e736 - _e655);
                    phi_1356_ = type_9(0u, 4u);
                    phi_1361_ = 0u;
                    loop {
                        let _e741 = phi_1356_;
                        let _e743 = phi_1361_;
                        local_4 = _e743;
                        local_5 = _e743;
                        let _e746 = (_e741.member < _e741.member_1);
                        let _e757 = select(type_9().member_1, _e741.member, _e746);
                        if (bitcast<i32>(select(0u, 1u, _e746)) != 0i) {
                            let _e761 = (_e53 + (_e757 * 128u));
                            if (_e761 >= select(_e737, 512u, (512u < _e737))) {
                                phi_2821_ = u32();
                                phi_2822_ = false;
                            } else {
                                let _e764 = hits[_e761];
                                let _e767 = ((_e764 >> bitcast<u32>(10i)) & 3u);
                                let _e775 = names[((_e767 * 32u) + (_e764 & 31u))];
                                let _e778 = firsts[(2u * _e767)];
                                let _e779 = (_e778 + ((_e764 >> bitcast<u32>(5i)) & 31u));
                                let _e783 = firsts[((2u * _e767) + 1u)];
                                let _e784 = (_e783 + _e775);
                                if ((_e71.member_1 & 512u) != 0u) {
                                    let _e790 = ends.member[(((_e779 / 32u) * 96u) + (_e779 % 32u))];
                                    let _e798 = ends.member[(((((_e779 / 32u) * 3u) + 1u) * 32u) + (_e779 % 32u))];
                                    let _e814 = ends.member[(((((_e779 / 32u) * 3u) + 2u) * 32u) + (_e779 % 32u))];
                                    let _e824 = ends.member[(((_e784 / 32u) * 96u) + (_e784 % 32u))];
                                    let _e832 = ends.member[(((((_e784 / 32u) * 3u) + 1u) * 32u) + (_e784 % 32u))];
                                    let _e848 = ends.member[(((((_e784 / 32u) * 3u) + 2u) * 32u) + (_e784 % 32u))];
                                    let _e859 = (((_e71.member_5 + (2f * _e71.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                                    phi_1584_ = !(((((((_e790.x - _e824.w) > _e859) && ((_e798.z - _e848.y) > _e859)) || (((_e824.x - _e790.w) > _e859) && ((_e832.z - _e814.y) > _e859))) || ((((_e790.y - _e832.x) > _e859) && ((_e798.w - _e848.z) > _e859)) || (((_e824.y - _e798.x) > _e859) && ((_e832.w - _e814.z) > _e859)))) || ((((_e790.z - _e832.y) > _e859) && ((_e814.x - _e848.w) > _e859)) || (((_e824.z - _e798.y) > _e859) && ((_e848.x - _e814.w) > _e859)))));
                                } else {
                                    phi_1584_ = true;
                                }
                                let _e897 = phi_1584_;
                                if _e897 {
                                    phi_1660_ = true;
                                } else {
                                    if ((_e71.member_1 & 2u) != 0u) {
                                        phi_1655_ = false;
                                    } else {
                                        if ((_e71.member_1 & 32u) != 0u) {
                                            let _e905 = nodes.member[_e779];
                                            let _e919 = nodes.member[_e784];
                                            phi_1654_ = (((((_e905.member_1.y - _e919.member.x) > _e71.member_6) && ((_e919.member_1.y - _e905.member.x) > _e71.member_6)) && (((_e905.member_2.x - _e919.member.y) > _e71.member_6) && ((_e919.member_2.x - _e905.member.y) > _e71.member_6))) && (((_e905.member_2.y - _e919.member_1.x) > _e71.member_6) && ((_e919.member_2.y - _e905.member_1.x) > _e71.member_6)));
                                        } else {
                                            phi_1654_ = true;
                                        }
                                        let _e951 = phi_1654_;
                                        phi_1655_ = _e951;
                                    }
                                    let _e953 = phi_1655_;
                                    phi_1660_ = select(true, false, _e953);
                                }
                                let _e956 = phi_1660_;
                                if _e956 {
                                    let _e958 = leaves.member[_e779];
                                    let _e964 = leaves.member[_e784];
                                    if ((_e71.member_1 & 32u) != 0u) {
                                        let _e973 = nodes.member[_e779];
                                        let _e990 = nodes.member[_e784];
                                        phi_1750_ = array<type_29, 2>(type_29(array<f32, 3>(_e973.member.x, _e973.member.y, _e973.member_1.x), array<f32, 3>(_e973.member_1.y, _e973.member_2.x, _e973.member_2.y)), type_29(array<f32, 3>(_e990.member.x, _e990.member.y, _e990.member_1.x), array<f32, 3>(_e990.member_1.y, _e990.member_2.x, _e990.member_2.y)));
                                    } else {
                                        phi_1750_ = array<type_29, 2>(type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)), type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)));
                                    }
                                    let _e1008 = phi_1750_;
                                    if ((_e71.member_1 & 1u) != 0u) {
                                        if (_e74 == 0u) {
                                            phi_1794_ = ((select((_e964.x == _e958.x), true, (_e964.x == _e958.x)) || select((_e964.y == _e958.x), true, (_e964.y == _e958.x))) || select((_e964.z == _e958.x), true, (_e964.z == _e958.x)));
                                        } else {
                                            phi_1794_ = (select((_e964.x == _e958.y), true, (_e964.x == _e958.x)) || select((_e964.y == _e958.y), true, (_e964.y == _e958.x)));
                                        }
                                        let _e1032 = phi_1794_;
                                        phi_1799_ = select(true, false, _e1032);
                                    } else {
                                        phi_1799_ = true;
                                    }
                                    let _e1035 = phi_1799_;
                                    if _e1035 {
                                        if ((_e71.member_1 & 2u) != 0u) {
                                            let _e1040 = bodies.member[_e958.x];
                                            let _e1042 = bodies.member[_e964.x];
                                            if select(false, (((_e1040 & _e1042) & 1u) == 0u), select(select(true, false, ((_e1040 & 2u) == 0u)), true, ((_e1040 / 4u) != (_e1042 / 4u)))) {
                                                if ((_e71.member_1 & 4u) != 0u) {
                                                    let _e1060 = bodies.member[_e71.member[0]];
                                                    let _e1063 = bodies.member[(_e71.member[0] + 1u)];
                                                    let _e1068 = ((_e71.member[0] + 4u) + (2u * (_e1040 >> bitcast<u32>(2i))));
                                                    let _e1073 = ((_e71.member[0] + 4u) + (2u * (_e1042 >> bitcast<u32>(2i))));
                                                    let _e1075 = bodies.member[_e1068];
                                                    let _e1077 = bodies.member[_e1073];
                                                    let _e1086 = bodies.member[((((_e71.member[0] + 4u) + (2u * _e1060)) + (_e1075 * _e1063)) + (_e1077 / 32u))];
                                                    let _e1089 = bodies.member[(_e1068 + 1u)];
                                                    let _e1092 = bodies.member[(_e1073 + 1u)];
                                                    if (_e1089 == _e1092) {
                                                        phi_1963_ = select(((_e1040 >> bitcast<u32>(2i)) == (_e1042 >> bitcast<u32>(2i))), true, (((_e1086 >> bitcast<u32>(((_e1077 % 32u) & 31u))) & 1u) == 1u));
                                                    } else {
                                                        phi_1963_ = false;
                                                    }
                                                    let _e1107 = phi_1963_;
                                                    if _e1107 {
                                                        let _e1110 = bodies.member[(_e71.member[0] + 2u)];
                                                        let _e1113 = bodies.member[(_e71.member[0] + 3u)];
                                                        let _e1114 = (_e1113 + _e71.member[0]);
                                                        let _e1115 = (_e74 == 1u);
                                                        let _e1116 = (_e964.w < _e958.w);
                                                        let _e1119 = select(_e964.w, select(_e964.w, _e958.w, _e1116), _e1115);
                                                        let _e1120 = select(_e958.w, select(_e958.w, _e964.w, _e1116), _e1115);
                                                        phi_2004_ = type_15(0i, 32i);
                                                        phi_2007_ = _e1110;
                                                        phi_2009_ = 0u;
                                                        loop {
                                                            let _e1122 = phi_2004_;
                                                            let _e1124 = phi_2007_;
                                                            let _e1126 = phi_2009_;
                                                            local_2 = _e1126;
                                                            local_3 = _e1126;
                                                            if (_e1122.member < _e1122.member_1) {
                                                                let _e1133 = (_e1122.member + 1i);
                                                                phi_2005_ = type_15(select(_e1133, type_16().member_1, select(false, true, ((false == (_e1133 > _e1122.member)) != false))), _e1122.member_1);
                                                                phi_2050_ = type_16(1u, _e1122.member);
                                                            } else {
                                                                phi_2005_ = _e1122;
                                                                phi_2050_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e1144 = phi_2005_;
                                                            let _e1146 = phi_2050_;
                                                            if (bitcast<i32>(_e1146.member) != 0i) {
                                                                if (_e1126 >= _e1124) {
                                                                    phi_2133_ = u32();
                                                                    phi_2134_ = u32();
                                                                    phi_2135_ = false;
                                                                } else {
                                                                    let _e1153 = (_e1126 + ((_e1124 - _e1126) / 2u));
                                                                    let _e1155 = (_e1114 + (3u * _e1153));
                                                                    let _e1157 = bodies.member[_e1155];
                                                                    let _e1160 = bodies.member[(_e1155 + 1u)];
                                                                    let _e1163 = bodies.member[(_e1155 + 2u)];
                                                                    if (_e1157 < _e74) {
                                                                        phi_2126_ = true;
                                                                    } else {
                                                                        phi_2126_ = select(true, false, select(true, select(select(true, select(true, false, (_e1163 < _e1119)), (_e1160 == _e1120)), false, (_e1160 < _e1120)), (_e1157 == _e74)));
                                                                    }
                                                                    let _e1175 = phi_2126_;
                                                                    phi_2133_ = select(_e1153, _e1124, _e1175);
                                                                    phi_2134_ = select(_e1126, (_e1153 + 1u), _e1175);
                                                                    phi_2135_ = true;
                                                                }
                                                                let _e1180 = phi_2133_;
                                                                let _e1182 = phi_2134_;
                                                                let _e1184 = phi_2135_;
                                                                phi_2008_ = _e1180;
                                                                phi_2010_ = _e1182;
                                                                phi_2136_ = _e1184;
                                                            } else {
                                                                phi_2008_ = u32();
                                                                phi_2010_ = u32();
                                                                phi_2136_ = false;
                                                            }
                                                            let _e1186 = phi_2008_;
                                                            let _e1188 = phi_2010_;
                                                            let _e1190 = phi_2136_;
                                                            continue;
                                                            continuing {
                                                                phi_2004_ = _e1144;
                                                                phi_2007_ = _e1186;
                                                                phi_2009_ = _e1188;
                                                                break if !(_e1190);
                                                            }
                                                        }
                                                        let _e1193 = local_2;
                                                        if (_e1193 < _e1110) {
                                                            let _e1196 = local_3;
                                                            let _e1198 = (_e1114 + (3u * _e1196));
                                                            let _e1200 = bodies.member[_e1198];
                                                            if (_e1200 == _e74) {
                                                                let _e1204 = bodies.member[(_e1198 + 1u)];
                                                                if (_e1204 == _e1120) {
                                                                    let _e1208 = bodies.member[(_e1198 + 2u)];
                                                                    phi_2184_ = (_e1208 == _e1119);
                                                                    phi_2185_ = false;
                                                                } else {
                                                                    phi_2184_ = bool();
                                                                    phi_2185_ = true;
                                                                }
                                                                let _e1211 = phi_2184_;
                                                                let _e1213 = phi_2185_;
                                                                phi_2186_ = _e1211;
                                                                phi_2187_ = _e1213;
                                                            } else {
                                                                phi_2186_ = bool();
                                                                phi_2187_ = true;
                                                            }
                                                            let _e1215 = phi_2186_;
                                                            let _e1217 = phi_2187_;
                                                            phi_2192_ = select(_e1215, false, _e1217);
                                                        } else {
                                                            phi_2192_ = false;
                                                        }
                                                        let _e1220 = phi_2192_;
                                                        phi_2196_ = _e1220;
                                                    } else {
                                                        phi_2196_ = true;
                                                    }
                                                    let _e1222 = phi_2196_;
                                                    phi_2201_ = select(true, false, _e1222);
                                                } else {
                                                    phi_2201_ = true;
                                                }
                                                let _e1225 = phi_2201_;
                                                phi_2206_ = select(true, false, _e1225);
                                            } else {
                                                phi_2206_ = true;
                                            }
                                            let _e1228 = phi_2206_;
                                            phi_2211_ = select(true, false, _e1228);
                                        } else {
                                            phi_2211_ = true;
                                        }
                                        let _e1231 = phi_2211_;
                                        if _e1231 {
                                            if ((_e71.member_1 & 32u) != 0u) {
                                                let _e1288 = (((((_e1008[0].member_1[0] - _e1008[1].member[0]) > _e71.member_6) && ((_e1008[1].member_1[0] - _e1008[0].member[0]) > _e71.member_6)) && (((_e1008[0].member_1[1] - _e1008[1].member[1]) > _e71.member_6) && ((_e1008[1].member_1[1] - _e1008[0].member[1]) > _e71.member_6))) && (((_e1008[0].member_1[2] - _e1008[1].member[2]) > _e71.member_6) && ((_e1008[1].member_1[2] - _e1008[0].member[2]) > _e71.member_6)));
                                                if _e1288 {
                                                    phi_2787_ = bool();
                                                } else {
                                                    let _e1290 = keys.member[_e958.x];
                                                    let _e1293 = keys.member[_e958.y];
                                                    let _e1295 = function_5(_e1290[0], _e1293[0]);
                                                    let _e1297 = keys.member[_e958.z];
                                                    let _e1299 = function_5(_e1295, _e1297[0]);
                                                    let _e1301 = keys.member[_e964.x];
                                                    let _e1304 = keys.member[_e964.y];
                                                    let _e1306 = function_4(_e1301[3], _e1304[3]);
                                                    let _e1308 = keys.member[_e964.z];
                                                    let _e1310 = function_4(_e1306, _e1308[3]);
                                                    let _e1324 = keys.member[_e964.x];
                                                    let _e1327 = keys.member[_e964.y];
                                                    let _e1329 = function_5(_e1324[0], _e1327[0]);
                                                    let _e1331 = keys.member[_e964.z];
                                                    let _e1333 = function_5(_e1329, _e1331[0]);
                                                    let _e1335 = keys.member[_e958.x];
                                                    let _e1338 = keys.member[_e958.y];
                                                    let _e1340 = function_4(_e1335[3], _e1338[3]);
                                                    let _e1342 = keys.member[_e958.z];
                                                    let _e1344 = function_4(_e1340, _e1342[3]);
                                                    let _e1359 = keys.member[_e958.x];
                                                    let _e1362 = keys.member[_e958.y];
                                                    let _e1364 = function_3(_e1359[1], _e1362[1]);
                                                    let _e1366 = keys.member[_e958.z];
                                                    let _e1368 = function_3(_e1364, _e1366[1]);
                                                    let _e1370 = keys.member[_e964.x];
                                                    let _e1373 = keys.member[_e964.y];
                                                    let _e1375 = function_2(_e1370[4], _e1373[4]);
                                                    let _e1377 = keys.member[_e964.z];
                                                    let _e1379 = function_2(_e1375, _e1377[4]);
                                                    let _e1393 = keys.member[_e964.x];
                                                    let _e1396 = keys.member[_e964.y];
                                                    let _e1398 = function_3(_e1393[1], _e1396[1]);
                                                    let _e1400 = keys.member[_e964.z];
                                                    let _e1402 = function_3(_e1398, _e1400[1]);
                                                    let _e1404 = keys.member[_e958.x];
                                                    let _e1407 = keys.member[_e958.y];
                                                    let _e1409 = function_2(_e1404[4], _e1407[4]);
                                                    let _e1411 = keys.member[_e958.z];
                                                    let _e1413 = function_2(_e1409, _e1411[4]);
                                                    let _e1429 = keys.member[_e958.x];
                                                    let _e1432 = keys.member[_e958.y];
                                                    let _e1434 = function_1(_e1429[2], _e1432[2]);
                                                    let _e1436 = keys.member[_e958.z];
                                                    let _e1438 = function_1(_e1434, _e1436[2]);
                                                    let _e1440 = keys.member[_e964.x];
                                                    let _e1443 = keys.member[_e964.y];
                                                    let _e1445 = function_(_e1440[5], _e1443[5]);
                                                    let _e1447 = keys.member[_e964.z];
                                                    let _e1449 = function_(_e1445, _e1447[5]);
                                                    let _e1463 = keys.member[_e964.x];
                                                    let _e1466 = keys.member[_e964.y];
                                                    let _e1468 = function_1(_e1463[2], _e1466[2]);
                                                    let _e1470 = keys.member[_e964.z];
                                                    let _e1472 = function_1(_e1468, _e1470[2]);
                                                    let _e1474 = keys.member[_e958.x];
                                                    let _e1477 = keys.member[_e958.y];
                                                    let _e1479 = function_(_e1474[5], _e1477[5]);
                                                    let _e1481 = keys.member[_e958.z];
                                                    let _e1483 = function_(_e1479, _e1481[5]);
                                                    phi_2787_ = (((!(select(select(false, (_e1299[0] > _e1310[0]), (_e1299[1] == _e1310[1])), true, (_e1299[1] > _e1310[1]))) && !(select(select(false, (_e1333[0] > _e1344[0]), (_e1333[1] == _e1344[1])), true, (_e1333[1] > _e1344[1])))) && (!(select(select(false, (_e1368[0] > _e1379[0]), (_e1368[1] == _e1379[1])), true, (_e1368[1] > _e1379[1]))) && !(select(select(false, (_e1402[0] > _e1413[0]), (_e1402[1] == _e1413[1])), true, (_e1402[1] > _e1413[1]))))) && (!(select(select(false, (_e1438[0] > _e1449[0]), (_e1438[1] == _e1449[1])), true, (_e1438[1] > _e1449[1]))) && !(select(select(false, (_e1472[0] > _e1483[0]), (_e1472[1] == _e1483[1])), true, (_e1472[1] > _e1483[1])))));
                                                }
                                                let _e1499 = phi_2787_;
                                                phi_2788_ = _e1499;
                                                phi_2789_ = _e1288;
                                            } else {
                                                phi_2788_ = bool();
                                                phi_2789_ = true;
                                            }
                                            let _e1501 = phi_2788_;
                                            let _e1503 = phi_2789_;
                                            phi_2794_ = _e1501;
                                            phi_2795_ = select(true, false, _e1503);
                                        } else {
                                            phi_2794_ = false;
                                            phi_2795_ = true;
                                        }
                                        let _e1506 = phi_2794_;
                                        let _e1508 = phi_2795_;
                                        phi_2796_ = _e1506;
                                        phi_2797_ = _e1508;
                                    } else {
                                        phi_2796_ = false;
                                        phi_2797_ = true;
                                    }
                                    let _e1510 = phi_2796_;
                                    let _e1512 = phi_2797_;
                                    let _e1513 = select(true, _e1510, _e1512);
                                    if _e1513 {
                                    } else {
                                        let _e1515 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_2819_ = select(_e743, select(_e743, (_e743 | (1u << bitcast<u32>((_e757 & 31u)))), _e897), _e1513);
                                } else {
                                    phi_2819_ = _e743;
                                }
                                let _e1523 = phi_2819_;
                                phi_2821_ = _e1523;
                                phi_2822_ = true;
                            }
                            let _e1525 = phi_2821_;
                            let _e1527 = phi_2822_;
                            phi_1362_ = _e1525;
                            phi_2823_ = _e1527;
                        } else {
                            phi_1362_ = u32();
                            phi_2823_ = false;
                        }
                        let _e1529 = phi_1362_;
                        let _e1531 = phi_2823_;
                        continue;
                        continuing {
                            phi_1356_ = type_9(select(_e741.member, (_e741.member + 1u), _e746), select(_e741.member_1, _e741.member_1, _e746));
                            phi_1361_ = _e1529;
                            break if !(_e1531);
                        }
                    }
                    let _e1535 = params.member.member_1.member_3;
                    let _e1537 = local_4;
                    let _e1540 = atomicAdd((&counters[5u]), countOneBits(_e1537));
                    workgroupBarrier();
                    if (_e53 == 0u) {
                        let _e1543 = atomicLoad((&counters[5u]));
                        if (_e1543 > 0u) {
                            let _e1547 = params.member.member.member_1;
                            if ((_e1547 & 1024u) != 0u) {
                                let _e1557 = atomicAdd((&output.member[0u]), _e1543);
                                let _e1558 = (_e1557 + _e1543);
                                let _e1560 = select(_e1558, 4294967295u, (_e1558 < _e1557));
                                let _e1563 = params.member.member_1.member_3;
                                if (_e1560 > _e1563) {
                                    let _e1566 = atomicMax((&output.member[2u]), _e1560);
                                }
                                phi_2882_ = _e1557;
                            } else {
                                let _e1551 = atomicAdd((&output.member[0u]), _e1543);
                                if ((_e1551 + _e1543) < _e1551) {
                                    let _e1555 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2882_ = _e1551;
                            }
                            let _e1568 = phi_2882_;
                            atomicStore((&counters[6u]), _e1568);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1572 = atomicLoad((&counters[6u]));
                    phi_2890_ = type_9(0u, 4u);
                    phi_2893_ = (_e1540 + _e1572);
                    loop {
                        let _e1575 = phi_2890_;
                        let _e1577 = phi_2893_;
                        let _e1580 = (_e1575.member < _e1575.member_1);
                        let _e1591 = select(type_9().member_1, _e1575.member, _e1580);
                        let _e1593 = (bitcast<i32>(select(0u, 1u, _e1580)) != 0i);
                        if _e1593 {
                            let _e1596 = local_5;
                            if (((_e1596 >> bitcast<u32>((_e1591 & 31u))) & 1u) == 1u) {
                                let _e1604 = hits[(_e53 + (_e1591 * 128u))];
                                let _e1607 = ((_e1604 >> bitcast<u32>(10i)) & 3u);
                                let _e1615 = names[((_e1607 * 32u) + (_e1604 & 31u))];
                                let _e1618 = firsts[(2u * _e1607)];
                                let _e1623 = firsts[((2u * _e1607) + 1u)];
                                let _e1626 = leaves.member[(_e1618 + ((_e1604 >> bitcast<u32>(5i)) & 31u))];
                                let _e1629 = leaves.member[(_e1623 + _e1615)];
                                if (_e74 == 1u) {
                                    let _e1633 = (_e1626.w < _e1629.w);
                                    phi_2991_ = type_9(select(_e1629.w, _e1626.w, _e1633), select(_e1626.w, _e1629.w, _e1633));
                                } else {
                                    phi_2991_ = type_9(_e1626.w, _e1629.w);
                                }
                                let _e1638 = phi_2991_;
                                if (_e1577 < _e1535) {
                                    let _e1642 = (2u * _e1577);
                                    atomicStore((&output.member[(4u + _e1642)]), _e1638.member);
                                    atomicStore((&output.member[(_e1642 + 5u)]), _e1638.member_1);
                                }
                                phi_3006_ = (_e1577 + 1u);
                            } else {
                                phi_3006_ = _e1577;
                            }
                            let _e1649 = phi_3006_;
                            phi_2894_ = _e1649;
                        } else {
                            phi_2894_ = u32();
                        }
                        let _e1651 = phi_2894_;
                        continue;
                        continuing {
                            phi_2890_ = type_9(select(_e1575.member, (_e1575.member + 1u), _e1580), select(_e1575.member_1, _e1575.member_1, _e1580));
                            phi_2893_ = _e1651;
                            break if !(_e1593);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1169_ = type_9(select(_e631.member, (_e631.member + 1u), _e634), select(_e631.member_1, _e631.member_1, _e634));
                    break if !(_e647);
                }
            }
        }
        continue;
        continuing {
            phi_303_ = type_9(select(_e130.member, (_e130.member + 1u), _e133), select(_e130.member_1, _e130.member_1, _e133));
            break if !(_e146);
        }
    }
    if (_e53 == 0u) {
        let _e1657 = atomicLoad((&counters[7u]));
        if (_e1657 > 0u) {
            let _e1660 = atomicAdd((&output.member[1u]), _e1657);
            if ((_e1660 + _e1657) < _e1660) {
                let _e1664 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
