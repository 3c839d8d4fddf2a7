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
    var phi_214_: u32;
    var phi_241_: u32;
    var phi_271_: u32;
    var phi_577_: bool;
    var phi_615_: type_29;
    var phi_647_: type_9;
    var phi_650_: u32;
    var phi_651_: u32;
    var local: u32;
    var local_1: u32;
    var phi_968_: type_9;
    var phi_971_: u32;
    var phi_972_: u32;
    var phi_1041_: u32;
    var phi_1084_: type_9;
    var phi_1148_: type_9;
    var phi_1151_: u32;
    var phi_1152_: u32;
    var phi_1271_: type_9;
    var phi_1276_: u32;
    var phi_1499_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1575_: bool;
    var phi_1665_: array<type_29, 2>;
    var phi_1709_: bool;
    var phi_1714_: bool;
    var phi_1878_: bool;
    var phi_1919_: type_15;
    var phi_1922_: u32;
    var phi_1924_: u32;
    var phi_1920_: type_15;
    var phi_1965_: type_16;
    var phi_2041_: bool;
    var phi_2048_: u32;
    var phi_2049_: u32;
    var phi_2050_: bool;
    var phi_1923_: u32;
    var phi_1925_: u32;
    var phi_2051_: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2099_: bool;
    var phi_2100_: bool;
    var phi_2101_: bool;
    var phi_2102_: bool;
    var phi_2107_: bool;
    var phi_2111_: bool;
    var phi_2116_: bool;
    var phi_2121_: bool;
    var phi_2126_: bool;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var phi_2704_: bool;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2711_: bool;
    var phi_2712_: bool;
    var phi_2734_: u32;
    var phi_2736_: u32;
    var phi_2737_: bool;
    var phi_1277_: u32;
    var phi_2738_: bool;
    var local_4: u32;
    var phi_2797_: u32;
    var phi_2805_: type_9;
    var phi_2808_: u32;
    var local_5: u32;
    var phi_2906_: type_9;
    var phi_2921_: u32;
    var phi_2809_: u32;
    var phi_272_: u32;
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
    let _e71 = params.member.member;
    let _e74 = params.member.member_2.member_1;
    let _e80 = params.member.member_1.member_2;
    let _e82 = input.member[0u];
    let _e84 = select(_e82, _e80, (_e80 < _e82));
    let _e87 = params.member.member_1.member_1;
    if (_e84 > _e87) {
        let _e91 = params.member.member_1.member_1;
        phi_214_ = (_e84 - _e91);
    } else {
        phi_214_ = 0u;
    }
    let _e94 = phi_214_;
    let _e97 = params.member.member_2.member_3;
    if (_e97 == 1u) {
        phi_241_ = _e94;
    } else {
        let _e101 = params.member.member_2.member_3;
        if (_e101 == 0u) {
            return;
        }
        let _e103 = (_e94 / _e101);
        if (_e101 == 0u) {
            return;
        }
        phi_241_ = select(_e103, (_e103 + 1u), ((_e94 % _e101) > 0u));
    }
    let _e110 = phi_241_;
    let _e113 = params.member.member_2.member_4;
    let _e115 = select(_e110, _e113, (_e113 < _e110));
    if (_e53 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    phi_271_ = ((_e51.y * _e52.x) + _e51.x);
    loop {
        let _e119 = phi_271_;
        let _e120 = (_e115 / 4u);
        let _e125 = (_e119 < select(_e120, (_e120 + 1u), ((_e115 % 4u) > 0u)));
        if _e125 {
            let _e128 = ((_e119 * 4u) + (_e53 / 32u));
            let _e129 = (_e128 < _e115);
            let _e132 = params.member.member_1.member_1;
            let _e135 = params.member.member_2.member_3;
            let _e139 = (2u * (_e132 + select(0u, (_e128 * _e135), _e129)));
            let _e142 = input.member[(4u + _e139)];
            let _e145 = input.member[(_e139 + 5u)];
            if (_e53 <= 5u) {
                atomicStore((&counters[_e53]), 0u);
            }
            workgroupBarrier();
            let _e148 = (_e74 == 0u);
            if ((_e53 % 32u) == 0u) {
                let _e154 = (_e53 / 32u);
                let _e160 = params.member.member_2.member[0u][select(1u, 0u, _e148)];
                firsts[(2u * _e154)] = (_e160 + (_e142 * 32u));
                let _e169 = params.member.member_2.member[0u][select(1u, 2u, _e148)];
                firsts[((2u * _e154) + 1u)] = (_e169 + (_e145 * 32u));
            }
            let _e174 = params.member.member_2.member_1;
            let _e175 = (_e174 == 0u);
            let _e176 = select(1u, 0u, _e175);
            let _e177 = select(1u, 2u, _e175);
            let _e178 = (_e53 / 32u);
            let _e179 = (_e53 % 32u);
            let _e181 = params.member.member_2.member_2;
            let _e185 = params.member.member_2.member[_e181][_e176];
            let _e188 = nodes.member[(_e185 + _e142)];
            let _e202 = params.member.member_2.member_2;
            let _e206 = params.member.member_2.member[_e202][_e177];
            let _e209 = nodes.member[(_e206 + _e145)];
            let _e223 = params.member.member_2.member_2;
            let _e230 = params.member.member_2.member[(_e223 - 1u)][_e176];
            let _e233 = nodes.member[(_e230 + ((_e142 * 32u) + _e179))];
            let _e250 = params.member.member_2.member_2;
            let _e257 = params.member.member_2.member[(_e250 - 1u)][_e177];
            let _e260 = nodes.member[(_e257 + ((_e145 * 32u) + _e179))];
            if _e129 {
                phi_577_ = ((((((_e233.member.x <= _e209.member_1.y) && (_e209.member.x <= _e233.member_1.y)) && (_e233.member.y <= _e209.member_2.x)) && (_e209.member.y <= _e233.member_2.x)) && (_e233.member_1.x <= _e209.member_2.y)) && (_e209.member_1.x <= _e233.member_2.y));
            } else {
                phi_577_ = false;
            }
            let _e285 = phi_577_;
            if _e129 {
                if ((((((_e260.member.x <= _e188.member_1.y) && (_e188.member.x <= _e260.member_1.y)) && (_e260.member.y <= _e188.member_2.x)) && (_e188.member.y <= _e260.member_2.x)) && (_e260.member_1.x <= _e188.member_2.y)) && (_e188.member_1.x <= _e260.member_2.y)) {
                    let _e299 = atomicAdd((&counters[_e178]), 1u);
                    let _e300 = ((_e178 * 32u) + _e299);
                    columns[_e300] = type_29(array<f32, 3>(_e260.member.x, _e260.member.y, _e260.member_1.x), array<f32, 3>(_e260.member_1.y, _e260.member_2.x, _e260.member_2.y));
                    names[_e300] = _e179;
                }
            }
            if _e285 {
                phi_615_ = type_29(array<f32, 3>(_e233.member.x, _e233.member.y, _e233.member_1.x), array<f32, 3>(_e233.member_1.y, _e233.member_2.x, _e233.member_2.y));
            } else {
                phi_615_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e307 = phi_615_;
            workgroupBarrier();
            let _e310 = select(false, (_e142 == _e145), (_e74 == 1u));
            let _e311 = (_e53 / 32u);
            let _e313 = (_e311 * 32u);
            let _e315 = atomicLoad((&counters[_e311]));
            let _e316 = (_e315 / 4u);
            phi_647_ = type_9(0u, select(_e316, (_e316 + 1u), ((_e315 % 4u) > 0u)));
            phi_650_ = 0u;
            loop {
                let _e323 = phi_647_;
                let _e325 = phi_650_;
                local = _e325;
                local_1 = _e325;
                let _e328 = (_e323.member < _e323.member_1);
                let _e341 = (bitcast<i32>(select(0u, 1u, _e328)) != 0i);
                if _e341 {
                    let _e342 = (4u * select(type_9().member_1, _e323.member, _e328));
                    let _e345 = columns[(_e313 + _e342)];
                    let _e384 = columns[((_e313 + _e342) + 1u)];
                    let _e425 = columns[((_e313 + _e342) + 2u)];
                    let _e466 = columns[((_e313 + _e342) + 3u)];
                    phi_651_ = (_e325 | ((((select(0u, 1u, ((((((_e307.member[0] <= _e345.member_1[0]) && (_e345.member[0] <= _e307.member_1[0])) && (_e307.member[1] <= _e345.member_1[1])) && (_e345.member[1] <= _e307.member_1[1])) && (_e307.member[2] <= _e345.member_1[2])) && (_e345.member[2] <= _e307.member_1[2]))) << bitcast<u32>((_e342 & 31u))) | (select(0u, 1u, ((((((_e307.member[0] <= _e384.member_1[0]) && (_e384.member[0] <= _e307.member_1[0])) && (_e307.member[1] <= _e384.member_1[1])) && (_e384.member[1] <= _e307.member_1[1])) && (_e307.member[2] <= _e384.member_1[2])) && (_e384.member[2] <= _e307.member_1[2]))) << bitcast<u32>(((_e342 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e307.member[0] <= _e425.member_1[0]) && (_e425.member[0] <= _e307.member_1[0])) && (_e307.member[1] <= _e425.member_1[1])) && (_e425.member[1] <= _e307.member_1[1])) && (_e307.member[2] <= _e425.member_1[2])) && (_e425.member[2] <= _e307.member_1[2]))) << bitcast<u32>(((_e342 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e307.member[0] <= _e466.member_1[0]) && (_e466.member[0] <= _e307.member_1[0])) && (_e307.member[1] <= _e466.member_1[1])) && (_e466.member[1] <= _e307.member_1[1])) && (_e307.member[2] <= _e466.member_1[2])) && (_e466.member[2] <= _e307.member_1[2]))) << bitcast<u32>(((_e342 + 3u) & 31u)))));
                } else {
                    phi_651_ = u32();
                }
                let _e506 = phi_651_;
                continue;
                continuing {
                    phi_647_ = type_9(select(_e323.member, (_e323.member + 1u), _e328), select(_e323.member_1, _e323.member_1, _e328));
                    phi_650_ = _e506;
                    break if !(_e341);
                }
            }
            let _e514 = local;
            let _e517 = local_1;
            let _e518 = select(_e517, (_e514 & ((1u << bitcast<u32>((_e315 & 31u))) - 1u)), (_e315 < 32u));
            if _e310 {
                phi_968_ = type_9(0u, _e315);
                phi_971_ = _e518;
                loop {
                    let _e521 = phi_968_;
                    let _e523 = phi_971_;
                    local_6 = _e523;
                    let _e526 = (_e521.member < _e521.member_1);
                    let _e537 = select(type_9().member_1, _e521.member, _e526);
                    let _e539 = (bitcast<i32>(select(0u, 1u, _e526)) != 0i);
                    if _e539 {
                        let _e542 = names[(_e313 + _e537)];
                        let _e543 = ((_e53 % 32u) < _e542);
                        phi_972_ = select(_e523, (_e523 & ~((1u << bitcast<u32>((_e537 & 31u))))), select(true, false, select(select(bool(), select(false, bool(), _e543), _e310), true, select(true, _e543, _e310))));
                    } else {
                        phi_972_ = u32();
                    }
                    let _e556 = phi_972_;
                    continue;
                    continuing {
                        phi_968_ = type_9(select(_e521.member, (_e521.member + 1u), _e526), select(_e521.member_1, _e521.member_1, _e526));
                        phi_971_ = _e556;
                        break if !(_e539);
                    }
                }
                let _e1635 = local_6;
                phi_1041_ = _e1635;
            } else {
                phi_1041_ = _e518;
            }
            let _e559 = phi_1041_;
            let _e563 = atomicAdd((&counters[4u]), countOneBits(_e559));
            workgroupBarrier();
            if (_e53 == 0u) {
                let _e566 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e566;
            }
            let _e569 = workgroupUniformLoad((&n_hits[0u]));
            let _e570 = (_e569 / 512u);
            if (_e53 == 0u) {
                let _e577 = atomicLoad((&counters[7u]));
                let _e579 = n_hits[0u];
                atomicStore((&counters[7u]), (_e577 + _e579));
            }
            phi_1084_ = type_9(0u, select(_e570, (_e570 + 1u), ((_e569 % 512u) > 0u)));
            loop {
                let _e584 = phi_1084_;
                let _e587 = (_e584.member < _e584.member_1);
                let _e600 = (bitcast<i32>(select(0u, 1u, _e587)) != 0i);
                if _e600 {
                    let _e601 = (_e53 / 32u);
                    let _e607 = ((_e601 << bitcast<u32>(10i)) | ((_e53 % 32u) << bitcast<u32>(5i)));
                    let _e608 = (select(type_9().member_1, _e584.member, _e587) * 512u);
                    let _e611 = atomicLoad((&counters[_e601]));
                    let _e612 = (_e611 / 4u);
                    phi_1148_ = type_9(0u, select(_e612, (_e612 + 1u), ((_e611 % 4u) > 0u)));
                    phi_1151_ = (_e563 - _e608);
                    loop {
                        let _e619 = phi_1148_;
                        let _e621 = phi_1151_;
                        let _e624 = (_e619.member < _e619.member_1);
                        let _e637 = (bitcast<i32>(select(0u, 1u, _e624)) != 0i);
                        if _e637 {
                            let _e638 = (4u * select(type_9().member_1, _e619.member, _e624));
                            let _e644 = (((_e559 >> bitcast<u32>((_e638 & 31u))) & 1u) == 1u);
                            if _e644 {
                                if (_e621 < 512u) {
                                    hits[_e621] = (_e607 + _e638);
                                }
                            }
                            let _e648 = select(_e621, (_e621 + 1u), _e644);
                            let _e656 = (((_e559 >> bitcast<u32>(((_e638 + 1u) & 31u))) & 1u) == 1u);
                            if _e656 {
                                if (_e648 < 512u) {
                                    hits[_e648] = ((_e607 + _e638) + 1u);
                                }
                            }
                            let _e660 = select(_e648, (_e648 + 1u), _e656);
                            let _e668 = (((_e559 >> bitcast<u32>(((_e638 + 2u) & 31u))) & 1u) == 1u);
                            if _e668 {
                                if (_e660 < 512u) {
                                    hits[_e660] = ((_e607 + _e638) + 2u);
                                }
                            }
                            let _e672 = select(_e660, (_e660 + 1u), _e668);
                            let _e680 = (((_e559 >> bitcast<u32>(((_e638 + 3u) & 31u))) & 1u) == 1u);
                            if _e680 {
                                if (_e672 < 512u) {
                                    hits[_e672] = ((_e607 + _e638) + 3u);
                                }
                            }
                            phi_1152_ = select(_e672, (_e672 + 1u), _e680);
                        } else {
                            phi_1152_ = u32();
                        }
                        let _e686 = phi_1152_;
                        continue;
                        continuing {
                            phi_1148_ = type_9(select(_e619.member, (_e619.member + 1u), _e624), select(_e619.member_1, _e619.member_1, _e624));
                            phi_1151_ = _e686;
                            break if !(_e637);
                        }
                    }
                    workgroupBarrier();
                    let _e689 = n_hits[0u];
                    let _e690 = (_e689 - _e608);
                    phi_1271_ = type_9(0u, 4u);
                    phi_1276_ = 0u;
                    loop {
                        let _e694 = phi_1271_;
                        let _e696 = phi_1276_;
                        local_4 = _e696;
                        local_5 = _e696;
                        let _e699 = (_e694.member < _e694.member_1);
                        let _e710 = select(type_9().member_1, _e694.member, _e699);
                        if (bitcast<i32>(select(0u, 1u, _e699)) != 0i) {
                            let _e714 = (_e53 + (_e710 * 128u));
                            if (_e714 >= select(_e690, 512u, (512u < _e690))) {
                                phi_2736_ = u32();
                                phi_2737_ = false;
                            } else {
                                let _e717 = hits[_e714];
                                let _e720 = ((_e717 >> bitcast<u32>(10i)) & 3u);
                                let _e728 = names[((_e720 * 32u) + (_e717 & 31u))];
                                let _e731 = firsts[(2u * _e720)];
                                let _e732 = (_e731 + ((_e717 >> bitcast<u32>(5i)) & 31u));
                                let _e736 = firsts[((2u * _e720) + 1u)];
                                let _e737 = (_e736 + _e728);
                                if ((_e71.member_1 & 512u) != 0u) {
                                    let _e743 = ends.member[(((_e732 / 32u) * 96u) + (_e732 % 32u))];
                                    let _e751 = ends.member[(((((_e732 / 32u) * 3u) + 1u) * 32u) + (_e732 % 32u))];
                                    let _e767 = ends.member[(((((_e732 / 32u) * 3u) + 2u) * 32u) + (_e732 % 32u))];
                                    let _e777 = ends.member[(((_e737 / 32u) * 96u) + (_e737 % 32u))];
                                    let _e785 = ends.member[(((((_e737 / 32u) * 3u) + 1u) * 32u) + (_e737 % 32u))];
                                    let _e801 = ends.member[(((((_e737 / 32u) * 3u) + 2u) * 32u) + (_e737 % 32u))];
                                    let _e812 = (((_e71.member_5 + (2f * _e71.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                                    phi_1499_ = !(((((((_e743.x - _e777.w) > _e812) && ((_e751.z - _e801.y) > _e812)) || (((_e777.x - _e743.w) > _e812) && ((_e785.z - _e767.y) > _e812))) || ((((_e743.y - _e785.x) > _e812) && ((_e751.w - _e801.z) > _e812)) || (((_e777.y - _e751.x) > _e812) && ((_e785.w - _e767.z) > _e812)))) || ((((_e743.z - _e785.y) > _e812) && ((_e767.x - _e801.w) > _e812)) || (((_e777.z - _e751.y) > _e812) && ((_e801.x - _e767.w) > _e812)))));
                                } else {
                                    phi_1499_ = true;
                                }
                                let _e850 = phi_1499_;
                                if _e850 {
                                    phi_1575_ = true;
                                } else {
                                    if ((_e71.member_1 & 2u) != 0u) {
                                        phi_1570_ = false;
                                    } else {
                                        if ((_e71.member_1 & 32u) != 0u) {
                                            let _e858 = nodes.member[_e732];
                                            let _e872 = nodes.member[_e737];
                                            phi_1569_ = (((((_e858.member_1.y - _e872.member.x) > _e71.member_6) && ((_e872.member_1.y - _e858.member.x) > _e71.member_6)) && (((_e858.member_2.x - _e872.member.y) > _e71.member_6) && ((_e872.member_2.x - _e858.member.y) > _e71.member_6))) && (((_e858.member_2.y - _e872.member_1.x) > _e71.member_6) && ((_e872.member_2.y - _e858.member_1.x) > _e71.member_6)));
                                        } else {
                                            phi_1569_ = true;
                                        }
                                        let _e904 = phi_1569_;
                                        phi_1570_ = _e904;
                                    }
                                    let _e906 = phi_1570_;
                                    phi_1575_ = select(true, false, _e906);
                                }
                                let _e909 = phi_1575_;
                                if _e909 {
                                    let _e911 = leaves.member[_e732];
                                    let _e917 = leaves.member[_e737];
                                    if ((_e71.member_1 & 32u) != 0u) {
                                        let _e926 = nodes.member[_e732];
                                        let _e943 = nodes.member[_e737];
                                        phi_1665_ = array<type_29, 2>(type_29(array<f32, 3>(_e926.member.x, _e926.member.y, _e926.member_1.x), array<f32, 3>(_e926.member_1.y, _e926.member_2.x, _e926.member_2.y)), type_29(array<f32, 3>(_e943.member.x, _e943.member.y, _e943.member_1.x), array<f32, 3>(_e943.member_1.y, _e943.member_2.x, _e943.member_2.y)));
                                    } else {
                                        phi_1665_ = array<type_29, 2>(type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)), type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)));
                                    }
                                    let _e961 = phi_1665_;
                                    if ((_e71.member_1 & 1u) != 0u) {
                                        if (_e74 == 0u) {
                                            phi_1709_ = ((select((_e917.x == _e911.x), true, (_e917.x == _e911.x)) || select((_e917.y == _e911.x), true, (_e917.y == _e911.x))) || select((_e917.z == _e911.x), true, (_e917.z == _e911.x)));
                                        } else {
                                            phi_1709_ = (select((_e917.x == _e911.y), true, (_e917.x == _e911.x)) || select((_e917.y == _e911.y), true, (_e917.y == _e911.x)));
                                        }
                                        let _e985 = phi_1709_;
                                        phi_1714_ = select(true, false, _e985);
                                    } else {
                                        phi_1714_ = true;
                                    }
                                    let _e988 = phi_1714_;
                                    if _e988 {
                                        if ((_e71.member_1 & 2u) != 0u) {
                                            let _e993 = bodies.member[_e911.x];
                                            let _e995 = bodies.member[_e917.x];
                                            if select(false, (((_e993 & _e995) & 1u) == 0u), select(select(true, false, ((_e993 & 2u) == 0u)), true, ((_e993 / 4u) != (_e995 / 4u)))) {
                                                if ((_e71.member_1 & 4u) != 0u) {
                                                    let _e1013 = bodies.member[_e71.member[0]];
                                                    let _e1016 = bodies.member[(_e71.member[0] + 1u)];
                                                    let _e1021 = ((_e71.member[0] + 4u) + (2u * (_e993 >> bitcast<u32>(2i))));
                                                    let _e1026 = ((_e71.member[0] + 4u) + (2u * (_e995 >> bitcast<u32>(2i))));
                                                    let _e1028 = bodies.member[_e1021];
                                                    let _e1030 = bodies.member[_e1026];
                                                    let _e1039 = bodies.member[((((_e71.member[0] + 4u) + (2u * _e1013)) + (_e1028 * _e1016)) + (_e1030 / 32u))];
                                                    let _e1042 = bodies.member[(_e1021 + 1u)];
                                                    let _e1045 = bodies.member[(_e1026 + 1u)];
                                                    if (_e1042 == _e1045) {
                                                        phi_1878_ = select(((_e993 >> bitcast<u32>(2i)) == (_e995 >> bitcast<u32>(2i))), true, (((_e1039 >> bitcast<u32>(((_e1030 % 32u) & 31u))) & 1u) == 1u));
                                                    } else {
                                                        phi_1878_ = false;
                                                    }
                                                    let _e1060 = phi_1878_;
                                                    if _e1060 {
                                                        let _e1063 = bodies.member[(_e71.member[0] + 2u)];
                                                        let _e1066 = bodies.member[(_e71.member[0] + 3u)];
                                                        let _e1067 = (_e1066 + _e71.member[0]);
                                                        let _e1068 = (_e74 == 1u);
                                                        let _e1069 = (_e917.w < _e911.w);
                                                        let _e1072 = select(_e917.w, select(_e917.w, _e911.w, _e1069), _e1068);
                                                        let _e1073 = select(_e911.w, select(_e911.w, _e917.w, _e1069), _e1068);
                                                        phi_1919_ = type_15(0i, 32i);
                                                        phi_1922_ = _e1063;
                                                        phi_1924_ = 0u;
                                                        loop {
                                                            let _e1075 = phi_1919_;
                                                            let _e1077 = phi_1922_;
                                                            let _e1079 = phi_1924_;
                                                            local_2 = _e1079;
                                                            local_3 = _e1079;
                                                            if (_e1075.member < _e1075.member_1) {
                                                                let _e1086 = (_e1075.member + 1i);
                                                                phi_1920_ = type_15(select(_e1086, type_16().member_1, select(false, true, ((false == (_e1086 > _e1075.member)) != false))), _e1075.member_1);
                                                                phi_1965_ = type_16(1u, _e1075.member);
                                                            } else {
                                                                phi_1920_ = _e1075;
                                                                phi_1965_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e1097 = phi_1920_;
                                                            let _e1099 = phi_1965_;
                                                            if (bitcast<i32>(_e1099.member) != 0i) {
                                                                if (_e1079 >= _e1077) {
                                                                    phi_2048_ = u32();
                                                                    phi_2049_ = u32();
                                                                    phi_2050_ = false;
                                                                } else {
                                                                    let _e1106 = (_e1079 + ((_e1077 - _e1079) / 2u));
                                                                    let _e1108 = (_e1067 + (3u * _e1106));
                                                                    let _e1110 = bodies.member[_e1108];
                                                                    let _e1113 = bodies.member[(_e1108 + 1u)];
                                                                    let _e1116 = bodies.member[(_e1108 + 2u)];
                                                                    if (_e1110 < _e74) {
                                                                        phi_2041_ = true;
                                                                    } else {
                                                                        phi_2041_ = select(true, false, select(true, select(select(true, select(true, false, (_e1116 < _e1072)), (_e1113 == _e1073)), false, (_e1113 < _e1073)), (_e1110 == _e74)));
                                                                    }
                                                                    let _e1128 = phi_2041_;
                                                                    phi_2048_ = select(_e1106, _e1077, _e1128);
                                                                    phi_2049_ = select(_e1079, (_e1106 + 1u), _e1128);
                                                                    phi_2050_ = true;
                                                                }
                                                                let _e1133 = phi_2048_;
                                                                let _e1135 = phi_2049_;
                                                                let _e1137 = phi_2050_;
                                                                phi_1923_ = _e1133;
                                                                phi_1925_ = _e1135;
                                                                phi_2051_ = _e1137;
                                                            } else {
                                                                phi_1923_ = u32();
                                                                phi_1925_ = u32();
                                                                phi_2051_ = false;
                                                            }
                                                            let _e1139 = phi_1923_;
                                                            let _e1141 = phi_1925_;
                                                            let _e1143 = phi_2051_;
                                                            continue;
                                                            continuing {
                                                                phi_1919_ = _e1097;
                                                                phi_1922_ = _e1139;
                                                                phi_1924_ = _e1141;
                                                                break if !(_e1143);
                                                            }
                                                        }
                                                        let _e1146 = local_2;
                                                        if (_e1146 < _e1063) {
                                                            let _e1149 = local_3;
                                                            let _e1151 = (_e1067 + (3u * _e1149));
                                                            let _e1153 = bodies.member[_e1151];
                                                            if (_e1153 == _e74) {
                                                                let _e1157 = bodies.member[(_e1151 + 1u)];
                                                                if (_e1157 == _e1073) {
                                                                    let _e1161 = bodies.member[(_e1151 + 2u)];
                                                                    phi_2099_ = (_e1161 == _e1072);
                                                                    phi_2100_ = false;
                                                                } else {
                                                                    phi_2099_ = bool();
                                                                    phi_2100_ = true;
                                                                }
                                                                let _e1164 = phi_2099_;
                                                                let _e1166 = phi_2100_;
                                                                phi_2101_ = _e1164;
                                                                phi_2102_ = _e1166;
                                                            } else {
                                                                phi_2101_ = bool();
                                                                phi_2102_ = true;
                                                            }
                                                            let _e1168 = phi_2101_;
                                                            let _e1170 = phi_2102_;
                                                            phi_2107_ = select(_e1168, false, _e1170);
                                                        } else {
                                                            phi_2107_ = false;
                                                        }
                                                        let _e1173 = phi_2107_;
                                                        phi_2111_ = _e1173;
                                                    } else {
                                                        phi_2111_ = true;
                                                    }
                                                    let _e1175 = phi_2111_;
                                                    phi_2116_ = select(true, false, _e1175);
                                                } else {
                                                    phi_2116_ = true;
                                                }
                                                let _e1178 = phi_2116_;
                                                phi_2121_ = select(true, false, _e1178);
                                            } else {
                                                phi_2121_ = true;
                                            }
                                            let _e1181 = phi_2121_;
                                            phi_2126_ = select(true, false, _e1181);
                                        } else {
                                            phi_2126_ = true;
                                        }
                                        let _e1184 = phi_2126_;
                                        if _e1184 {
                                            if ((_e71.member_1 & 32u) != 0u) {
                                                let _e1241 = (((((_e961[0].member_1[0] - _e961[1].member[0]) > _e71.member_6) && ((_e961[1].member_1[0] - _e961[0].member[0]) > _e71.member_6)) && (((_e961[0].member_1[1] - _e961[1].member[1]) > _e71.member_6) && ((_e961[1].member_1[1] - _e961[0].member[1]) > _e71.member_6))) && (((_e961[0].member_1[2] - _e961[1].member[2]) > _e71.member_6) && ((_e961[1].member_1[2] - _e961[0].member[2]) > _e71.member_6)));
                                                if _e1241 {
                                                    phi_2702_ = bool();
                                                } else {
                                                    let _e1243 = keys.member[_e911.x];
                                                    let _e1246 = keys.member[_e911.y];
                                                    let _e1248 = function_5(_e1243[0], _e1246[0]);
                                                    let _e1250 = keys.member[_e911.z];
                                                    let _e1252 = function_5(_e1248, _e1250[0]);
                                                    let _e1254 = keys.member[_e917.x];
                                                    let _e1257 = keys.member[_e917.y];
                                                    let _e1259 = function_4(_e1254[3], _e1257[3]);
                                                    let _e1261 = keys.member[_e917.z];
                                                    let _e1263 = function_4(_e1259, _e1261[3]);
                                                    let _e1277 = keys.member[_e917.x];
                                                    let _e1280 = keys.member[_e917.y];
                                                    let _e1282 = function_5(_e1277[0], _e1280[0]);
                                                    let _e1284 = keys.member[_e917.z];
                                                    let _e1286 = function_5(_e1282, _e1284[0]);
                                                    let _e1288 = keys.member[_e911.x];
                                                    let _e1291 = keys.member[_e911.y];
                                                    let _e1293 = function_4(_e1288[3], _e1291[3]);
                                                    let _e1295 = keys.member[_e911.z];
                                                    let _e1297 = function_4(_e1293, _e1295[3]);
                                                    let _e1312 = keys.member[_e911.x];
                                                    let _e1315 = keys.member[_e911.y];
                                                    let _e1317 = function_3(_e1312[1], _e1315[1]);
                                                    let _e1319 = keys.member[_e911.z];
                                                    let _e1321 = function_3(_e1317, _e1319[1]);
                                                    let _e1323 = keys.member[_e917.x];
                                                    let _e1326 = keys.member[_e917.y];
                                                    let _e1328 = function_2(_e1323[4], _e1326[4]);
                                                    let _e1330 = keys.member[_e917.z];
                                                    let _e1332 = function_2(_e1328, _e1330[4]);
                                                    let _e1346 = keys.member[_e917.x];
                                                    let _e1349 = keys.member[_e917.y];
                                                    let _e1351 = function_3(_e1346[1], _e1349[1]);
                                                    let _e1353 = keys.member[_e917.z];
                                                    let _e1355 = function_3(_e1351, _e1353[1]);
                                                    let _e1357 = keys.member[_e911.x];
                                                    let _e1360 = keys.member[_e911.y];
                                                    let _e1362 = function_2(_e1357[4], _e1360[4]);
                                                    let _e1364 = keys.member[_e911.z];
                                                    let _e1366 = function_2(_e1362, _e1364[4]);
                                                    let _e1382 = keys.member[_e911.x];
                                                    let _e1385 = keys.member[_e911.y];
                                                    let _e1387 = function_1(_e1382[2], _e1385[2]);
                                                    let _e1389 = keys.member[_e911.z];
                                                    let _e1391 = function_1(_e1387, _e1389[2]);
                                                    let _e1393 = keys.member[_e917.x];
                                                    let _e1396 = keys.member[_e917.y];
                                                    let _e1398 = function_(_e1393[5], _e1396[5]);
                                                    let _e1400 = keys.member[_e917.z];
                                                    let _e1402 = function_(_e1398, _e1400[5]);
                                                    let _e1416 = keys.member[_e917.x];
                                                    let _e1419 = keys.member[_e917.y];
                                                    let _e1421 = function_1(_e1416[2], _e1419[2]);
                                                    let _e1423 = keys.member[_e917.z];
                                                    let _e1425 = function_1(_e1421, _e1423[2]);
                                                    let _e1427 = keys.member[_e911.x];
                                                    let _e1430 = keys.member[_e911.y];
                                                    let _e1432 = function_(_e1427[5], _e1430[5]);
                                                    let _e1434 = keys.member[_e911.z];
                                                    let _e1436 = function_(_e1432, _e1434[5]);
                                                    phi_2702_ = (((!(select(select(false, (_e1252[0] > _e1263[0]), (_e1252[1] == _e1263[1])), true, (_e1252[1] > _e1263[1]))) && !(select(select(false, (_e1286[0] > _e1297[0]), (_e1286[1] == _e1297[1])), true, (_e1286[1] > _e1297[1])))) && (!(select(select(false, (_e1321[0] > _e1332[0]), (_e1321[1] == _e1332[1])), true, (_e1321[1] > _e1332[1]))) && !(select(select(false, (_e1355[0] > _e1366[0]), (_e1355[1] == _e1366[1])), true, (_e1355[1] > _e1366[1]))))) && (!(select(select(false, (_e1391[0] > _e1402[0]), (_e1391[1] == _e1402[1])), true, (_e1391[1] > _e1402[1]))) && !(select(select(false, (_e1425[0] > _e1436[0]), (_e1425[1] == _e1436[1])), true, (_e1425[1] > _e1436[1])))));
                                                }
                                                let _e1452 = phi_2702_;
                                                phi_2703_ = _e1452;
                                                phi_2704_ = _e1241;
                                            } else {
                                                phi_2703_ = bool();
                                                phi_2704_ = true;
                                            }
                                            let _e1454 = phi_2703_;
                                            let _e1456 = phi_2704_;
                                            phi_2709_ = _e1454;
                                            phi_2710_ = select(true, false, _e1456);
                                        } else {
                                            phi_2709_ = false;
                                            phi_2710_ = true;
                                        }
                                        let _e1459 = phi_2709_;
                                        let _e1461 = phi_2710_;
                                        phi_2711_ = _e1459;
                                        phi_2712_ = _e1461;
                                    } else {
                                        phi_2711_ = false;
                                        phi_2712_ = true;
                                    }
                                    let _e1463 = phi_2711_;
                                    let _e1465 = phi_2712_;
                                    let _e1466 = select(true, _e1463, _e1465);
                                    if _e1466 {
                                    } else {
                                        let _e1468 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_2734_ = select(_e696, select(_e696, (_e696 | (1u << bitcast<u32>((_e710 & 31u)))), _e850), _e1466);
                                } else {
                                    phi_2734_ = _e696;
                                }
                                let _e1476 = phi_2734_;
                                phi_2736_ = _e1476;
                                phi_2737_ = true;
                            }
                            let _e1478 = phi_2736_;
                            let _e1480 = phi_2737_;
                            phi_1277_ = _e1478;
                            phi_2738_ = _e1480;
                        } else {
                            phi_1277_ = u32();
                            phi_2738_ = false;
                        }
                        let _e1482 = phi_1277_;
                        let _e1484 = phi_2738_;
                        continue;
                        continuing {
                            phi_1271_ = type_9(select(_e694.member, (_e694.member + 1u), _e699), select(_e694.member_1, _e694.member_1, _e699));
                            phi_1276_ = _e1482;
                            break if !(_e1484);
                        }
                    }
                    let _e1488 = params.member.member_1.member_3;
                    let _e1490 = local_4;
                    let _e1493 = atomicAdd((&counters[5u]), countOneBits(_e1490));
                    workgroupBarrier();
                    if (_e53 == 0u) {
                        let _e1496 = atomicLoad((&counters[5u]));
                        if (_e1496 > 0u) {
                            let _e1500 = params.member.member.member_1;
                            if ((_e1500 & 1024u) != 0u) {
                                let _e1510 = atomicAdd((&output.member[0u]), _e1496);
                                let _e1511 = (_e1510 + _e1496);
                                let _e1513 = select(_e1511, 4294967295u, (_e1511 < _e1510));
                                let _e1516 = params.member.member_1.member_3;
                                if (_e1513 > _e1516) {
                                    let _e1519 = atomicMax((&output.member[2u]), _e1513);
                                }
                                phi_2797_ = _e1510;
                            } else {
                                let _e1504 = atomicAdd((&output.member[0u]), _e1496);
                                if ((_e1504 + _e1496) < _e1504) {
                                    let _e1508 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2797_ = _e1504;
                            }
                            let _e1521 = phi_2797_;
                            atomicStore((&counters[6u]), _e1521);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1525 = atomicLoad((&counters[6u]));
                    phi_2805_ = type_9(0u, 4u);
                    phi_2808_ = (_e1493 + _e1525);
                    loop {
                        let _e1528 = phi_2805_;
                        let _e1530 = phi_2808_;
                        let _e1533 = (_e1528.member < _e1528.member_1);
                        let _e1544 = select(type_9().member_1, _e1528.member, _e1533);
                        let _e1546 = (bitcast<i32>(select(0u, 1u, _e1533)) != 0i);
                        if _e1546 {
                            let _e1549 = local_5;
                            if (((_e1549 >> bitcast<u32>((_e1544 & 31u))) & 1u) == 1u) {
                                let _e1557 = hits[(_e53 + (_e1544 * 128u))];
                                let _e1560 = ((_e1557 >> bitcast<u32>(10i)) & 3u);
                                let _e1568 = names[((_e1560 * 32u) + (_e1557 & 31u))];
                                let _e1571 = firsts[(2u * _e1560)];
                                let _e1576 = firsts[((2u * _e1560) + 1u)];
                                let _e1579 = leaves.member[(_e1571 + ((_e1557 >> bitcast<u32>(5i)) & 31u))];
                                let _e1582 = leaves.member[(_e1576 + _e1568)];
                                if (_e74 == 1u) {
                                    let _e1586 = (_e1579.w < _e1582.w);
                                    phi_2906_ = type_9(select(_e1582.w, _e1579.w, _e1586), select(_e1579.w, _e1582.w, _e1586));
                                } else {
                                    phi_2906_ = type_9(_e1579.w, _e1582.w);
                                }
                                let _e1591 = phi_2906_;
                                if (_e1530 < _e1488) {
                                    let _e1595 = (2u * _e1530);
                                    atomicStore((&output.member[(4u + _e1595)]), _e1591.member);
                                    atomicStore((&output.member[(_e1595 + 5u)]), _e1591.member_1);
                                }
                                phi_2921_ = (_e1530 + 1u);
                            } else {
                                phi_2921_ = _e1530;
                            }
                            let _e1602 = phi_2921_;
                            phi_2809_ = _e1602;
                        } else {
                            phi_2809_ = u32();
                        }
                        let _e1604 = phi_2809_;
                        continue;
                        continuing {
                            phi_2805_ = type_9(select(_e1528.member, (_e1528.member + 1u), _e1533), select(_e1528.member_1, _e1528.member_1, _e1533));
                            phi_2808_ = _e1604;
                            break if !(_e1546);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1084_ = type_9(select(_e584.member, (_e584.member + 1u), _e587), select(_e584.member_1, _e584.member_1, _e587));
                    break if !(_e600);
                }
            }
            phi_272_ = (_e119 + (_e52.x * _e52.y));
        } else {
            phi_272_ = u32();
        }
        let _e1608 = phi_272_;
        continue;
        continuing {
            phi_271_ = _e1608;
            break if !(_e125);
        }
    }
    if (_e53 == 0u) {
        let _e1612 = atomicLoad((&counters[7u]));
        if (_e1612 > 0u) {
            let _e1615 = atomicAdd((&output.member[1u]), _e1612);
            if ((_e1615 + _e1612) < _e1615) {
                let _e1619 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_candidates(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
