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

struct type_41 {
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
var<storage> keys: type_11;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_41;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_1[0] > param[0]), (param_1[1] == param[1])), true, (param_1[1] > param[1]));
    return array<u32, 2>(select(param[0], param_1[0], _e14), select(param[1], param_1[1], _e14));
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    let _e14 = select(select(false, (param_2[0] > param_3[0]), (param_2[1] == param_3[1])), true, (param_2[1] > param_3[1]));
    return array<u32, 2>(select(param_2[0], param_3[0], _e14), select(param_2[1], param_3[1], _e14));
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_203_: u32;
    var phi_230_: u32;
    var phi_280_: u32;
    var phi_588_: bool;
    var phi_626_: type_29;
    var phi_658_: type_9;
    var phi_661_: u32;
    var phi_662_: u32;
    var local: u32;
    var local_1: u32;
    var phi_979_: type_9;
    var phi_982_: u32;
    var phi_983_: u32;
    var phi_1052_: u32;
    var phi_1097_: type_9;
    var phi_1159_: type_9;
    var phi_1162_: u32;
    var phi_1163_: u32;
    var phi_1282_: type_9;
    var phi_1285_: u32;
    var phi_1502_: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1578_: bool;
    var phi_1664_: array<type_29, 2>;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1873_: bool;
    var phi_1914_: type_15;
    var phi_1917_: u32;
    var phi_1915_: type_15;
    var phi_1958_: type_16;
    var phi_2037_: u32;
    var phi_1918_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_2085_: bool;
    var phi_2086_: bool;
    var phi_2087_: bool;
    var phi_2088_: bool;
    var phi_2093_: bool;
    var phi_2097_: bool;
    var phi_2102_: bool;
    var phi_2107_: bool;
    var phi_2112_: bool;
    var phi_2157_: type_9;
    var phi_2604_: bool;
    var phi_2605_: bool;
    var phi_2606_: bool;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var local_4: bool;
    var local_5: bool;
    var local_6: bool;
    var phi_2625_: bool;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2635_: bool;
    var phi_2656_: u32;
    var phi_2657_: u32;
    var phi_2658_: bool;
    var phi_1286_: u32;
    var phi_2659_: bool;
    var local_7: u32;
    var phi_2718_: u32;
    var phi_2726_: type_9;
    var phi_2729_: u32;
    var local_8: u32;
    var phi_2827_: type_9;
    var phi_2842_: u32;
    var phi_2730_: u32;
    var phi_281_: u32;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e53 = id_2;
    let _e54 = n_2;
    let _e55 = lane_2;
    let _e74 = params.member.member_1.member_2;
    let _e76 = input.member[0u];
    let _e78 = select(_e76, _e74, (_e74 < _e76));
    let _e81 = params.member.member_1.member_1;
    if (_e78 > _e81) {
        let _e85 = params.member.member_1.member_1;
        phi_203_ = (_e78 - _e85);
    } else {
        phi_203_ = 0u;
    }
    let _e88 = phi_203_;
    let _e91 = params.member.member_2.member_3;
    if (_e91 == 1u) {
        phi_230_ = _e88;
    } else {
        let _e95 = params.member.member_2.member_3;
        if (_e95 == 0u) {
            return;
        }
        let _e97 = (_e88 / _e95);
        if (_e95 == 0u) {
            return;
        }
        phi_230_ = select(_e97, (_e97 + 1u), ((_e88 % _e95) > 0u));
    }
    let _e104 = phi_230_;
    let _e107 = params.member.member_2.member_4;
    let _e109 = select(_e104, _e107, (_e107 < _e104));
    let _e111 = params.member.member;
    let _e114 = params.member.member_2.member_1;
    let _e124 = (((_e111.member_5 + (2f * _e111.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
    if (_e55 == 0u) {
        atomicStore((&counters[7u]), 0u);
    }
    phi_280_ = ((_e53.y * _e54.x) + _e53.x);
    loop {
        let _e128 = phi_280_;
        let _e129 = (_e109 / 4u);
        let _e134 = (_e128 < select(_e129, (_e129 + 1u), ((_e109 % 4u) > 0u)));
        if _e134 {
            let _e137 = ((_e128 * 4u) + (_e55 / 32u));
            let _e138 = (_e137 < _e109);
            let _e141 = params.member.member_1.member_1;
            let _e144 = params.member.member_2.member_3;
            let _e148 = (2u * (_e141 + select(0u, (_e137 * _e144), _e138)));
            let _e151 = input.member[(4u + _e148)];
            let _e154 = input.member[(_e148 + 5u)];
            if (_e55 <= 5u) {
                atomicStore((&counters[_e55]), 0u);
            }
            workgroupBarrier();
            let _e157 = (_e114 == 0u);
            if ((_e55 % 32u) == 0u) {
                let _e163 = (_e55 / 32u);
                let _e169 = params.member.member_2.member[0u][select(1u, 0u, _e157)];
                firsts[(2u * _e163)] = (_e169 + (_e151 * 32u));
                let _e178 = params.member.member_2.member[0u][select(1u, 2u, _e157)];
                firsts[((2u * _e163) + 1u)] = (_e178 + (_e154 * 32u));
            }
            let _e183 = params.member.member_2.member_1;
            let _e184 = (_e183 == 0u);
            let _e185 = select(1u, 0u, _e184);
            let _e186 = select(1u, 2u, _e184);
            let _e187 = (_e55 / 32u);
            let _e188 = (_e55 % 32u);
            let _e190 = params.member.member_2.member_2;
            let _e194 = params.member.member_2.member[_e190][_e185];
            let _e197 = nodes.member[(_e194 + _e151)];
            let _e211 = params.member.member_2.member_2;
            let _e215 = params.member.member_2.member[_e211][_e186];
            let _e218 = nodes.member[(_e215 + _e154)];
            let _e232 = params.member.member_2.member_2;
            let _e239 = params.member.member_2.member[(_e232 - 1u)][_e185];
            let _e242 = nodes.member[(_e239 + ((_e151 * 32u) + _e188))];
            let _e259 = params.member.member_2.member_2;
            let _e266 = params.member.member_2.member[(_e259 - 1u)][_e186];
            let _e269 = nodes.member[(_e266 + ((_e154 * 32u) + _e188))];
            if _e138 {
                phi_588_ = ((((((_e242.member.x <= _e218.member_1.y) && (_e218.member.x <= _e242.member_1.y)) && (_e242.member.y <= _e218.member_2.x)) && (_e218.member.y <= _e242.member_2.x)) && (_e242.member_1.x <= _e218.member_2.y)) && (_e218.member_1.x <= _e242.member_2.y));
            } else {
                phi_588_ = false;
            }
            let _e294 = phi_588_;
            if _e138 {
                if ((((((_e269.member.x <= _e197.member_1.y) && (_e197.member.x <= _e269.member_1.y)) && (_e269.member.y <= _e197.member_2.x)) && (_e197.member.y <= _e269.member_2.x)) && (_e269.member_1.x <= _e197.member_2.y)) && (_e197.member_1.x <= _e269.member_2.y)) {
                    let _e308 = atomicAdd((&counters[_e187]), 1u);
                    let _e309 = ((_e187 * 32u) + _e308);
                    columns[_e309] = type_29(array<f32, 3>(_e269.member.x, _e269.member.y, _e269.member_1.x), array<f32, 3>(_e269.member_1.y, _e269.member_2.x, _e269.member_2.y));
                    names[_e309] = _e188;
                }
            }
            if _e294 {
                phi_626_ = type_29(array<f32, 3>(_e242.member.x, _e242.member.y, _e242.member_1.x), array<f32, 3>(_e242.member_1.y, _e242.member_2.x, _e242.member_2.y));
            } else {
                phi_626_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e316 = phi_626_;
            workgroupBarrier();
            let _e319 = select(false, (_e151 == _e154), (_e114 == 1u));
            let _e320 = (_e55 / 32u);
            let _e322 = (_e320 * 32u);
            let _e324 = atomicLoad((&counters[_e320]));
            let _e325 = (_e324 / 4u);
            phi_658_ = type_9(0u, select(_e325, (_e325 + 1u), ((_e324 % 4u) > 0u)));
            phi_661_ = 0u;
            loop {
                let _e332 = phi_658_;
                let _e334 = phi_661_;
                local = _e334;
                local_1 = _e334;
                let _e337 = (_e332.member < _e332.member_1);
                let _e350 = (bitcast<i32>(select(0u, 1u, _e337)) != 0i);
                if _e350 {
                    let _e351 = (4u * select(type_9().member_1, _e332.member, _e337));
                    let _e354 = columns[(_e322 + _e351)];
                    let _e393 = columns[((_e322 + _e351) + 1u)];
                    let _e434 = columns[((_e322 + _e351) + 2u)];
                    let _e475 = columns[((_e322 + _e351) + 3u)];
                    phi_662_ = (_e334 | ((((select(0u, 1u, ((((((_e316.member[0] <= _e354.member_1[0]) && (_e354.member[0] <= _e316.member_1[0])) && (_e316.member[1] <= _e354.member_1[1])) && (_e354.member[1] <= _e316.member_1[1])) && (_e316.member[2] <= _e354.member_1[2])) && (_e354.member[2] <= _e316.member_1[2]))) << bitcast<u32>((_e351 & 31u))) | (select(0u, 1u, ((((((_e316.member[0] <= _e393.member_1[0]) && (_e393.member[0] <= _e316.member_1[0])) && (_e316.member[1] <= _e393.member_1[1])) && (_e393.member[1] <= _e316.member_1[1])) && (_e316.member[2] <= _e393.member_1[2])) && (_e393.member[2] <= _e316.member_1[2]))) << bitcast<u32>(((_e351 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e316.member[0] <= _e434.member_1[0]) && (_e434.member[0] <= _e316.member_1[0])) && (_e316.member[1] <= _e434.member_1[1])) && (_e434.member[1] <= _e316.member_1[1])) && (_e316.member[2] <= _e434.member_1[2])) && (_e434.member[2] <= _e316.member_1[2]))) << bitcast<u32>(((_e351 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e316.member[0] <= _e475.member_1[0]) && (_e475.member[0] <= _e316.member_1[0])) && (_e316.member[1] <= _e475.member_1[1])) && (_e475.member[1] <= _e316.member_1[1])) && (_e316.member[2] <= _e475.member_1[2])) && (_e475.member[2] <= _e316.member_1[2]))) << bitcast<u32>(((_e351 + 3u) & 31u)))));
                } else {
                    phi_662_ = u32();
                }
                let _e515 = phi_662_;
                continue;
                continuing {
                    phi_658_ = type_9(select(_e332.member, (_e332.member + 1u), _e337), select(_e332.member_1, _e332.member_1, _e337));
                    phi_661_ = _e515;
                    break if !(_e350);
                }
            }
            let _e523 = local;
            let _e526 = local_1;
            let _e527 = select(_e526, (_e523 & ((1u << bitcast<u32>((_e324 & 31u))) - 1u)), (_e324 < 32u));
            if _e319 {
                phi_979_ = type_9(0u, _e324);
                phi_982_ = _e527;
                loop {
                    let _e530 = phi_979_;
                    let _e532 = phi_982_;
                    local_9 = _e532;
                    let _e535 = (_e530.member < _e530.member_1);
                    let _e546 = select(type_9().member_1, _e530.member, _e535);
                    let _e548 = (bitcast<i32>(select(0u, 1u, _e535)) != 0i);
                    if _e548 {
                        let _e551 = names[(_e322 + _e546)];
                        let _e552 = ((_e55 % 32u) < _e551);
                        phi_983_ = select(_e532, (_e532 & ~((1u << bitcast<u32>((_e546 & 31u))))), select(true, false, select(select(bool(), select(false, bool(), _e552), _e319), true, select(true, _e552, _e319))));
                    } else {
                        phi_983_ = u32();
                    }
                    let _e565 = phi_983_;
                    continue;
                    continuing {
                        phi_979_ = type_9(select(_e530.member, (_e530.member + 1u), _e535), select(_e530.member_1, _e530.member_1, _e535));
                        phi_982_ = _e565;
                        break if !(_e548);
                    }
                }
                let _e1612 = local_9;
                phi_1052_ = _e1612;
            } else {
                phi_1052_ = _e527;
            }
            let _e568 = phi_1052_;
            let _e572 = atomicAdd((&counters[4u]), countOneBits(_e568));
            workgroupBarrier();
            if (_e55 == 0u) {
                let _e575 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e575;
            }
            let _e578 = workgroupUniformLoad((&n_hits[0u]));
            let _e579 = (_e578 / 512u);
            if (_e55 == 0u) {
                let _e586 = atomicLoad((&counters[7u]));
                let _e588 = n_hits[0u];
                atomicStore((&counters[7u]), (_e586 + _e588));
            }
            phi_1097_ = type_9(0u, select(_e579, (_e579 + 1u), ((_e578 % 512u) > 0u)));
            loop {
                let _e593 = phi_1097_;
                let _e596 = (_e593.member < _e593.member_1);
                let _e609 = (bitcast<i32>(select(0u, 1u, _e596)) != 0i);
                if _e609 {
                    let _e610 = (_e55 / 32u);
                    let _e616 = ((_e610 << bitcast<u32>(10i)) | ((_e55 % 32u) << bitcast<u32>(5i)));
                    let _e617 = (select(type_9().member_1, _e593.member, _e596) * 512u);
                    let _e620 = atomicLoad((&counters[_e610]));
                    let _e621 = (_e620 / 4u);
                    phi_1159_ = type_9(0u, select(_e621, (_e621 + 1u), ((_e620 % 4u) > 0u)));
                    phi_1162_ = (_e572 - _e617);
                    loop {
                        let _e628 = phi_1159_;
                        let _e630 = phi_1162_;
                        let _e633 = (_e628.member < _e628.member_1);
                        let _e646 = (bitcast<i32>(select(0u, 1u, _e633)) != 0i);
                        if _e646 {
                            let _e647 = (4u * select(type_9().member_1, _e628.member, _e633));
                            let _e653 = (((_e568 >> bitcast<u32>((_e647 & 31u))) & 1u) == 1u);
                            if _e653 {
                                if (_e630 < 512u) {
                                    hits[_e630] = (_e616 + _e647);
                                }
                            }
                            let _e657 = select(_e630, (_e630 + 1u), _e653);
                            let _e665 = (((_e568 >> bitcast<u32>(((_e647 + 1u) & 31u))) & 1u) == 1u);
                            if _e665 {
                                if (_e657 < 512u) {
                                    hits[_e657] = ((_e616 + _e647) + 1u);
                                }
                            }
                            let _e669 = select(_e657, (_e657 + 1u), _e665);
                            let _e677 = (((_e568 >> bitcast<u32>(((_e647 + 2u) & 31u))) & 1u) == 1u);
                            if _e677 {
                                if (_e669 < 512u) {
                                    hits[_e669] = ((_e616 + _e647) + 2u);
                                }
                            }
                            let _e681 = select(_e669, (_e669 + 1u), _e677);
                            let _e689 = (((_e568 >> bitcast<u32>(((_e647 + 3u) & 31u))) & 1u) == 1u);
                            if _e689 {
                                if (_e681 < 512u) {
                                    hits[_e681] = ((_e616 + _e647) + 3u);
                                }
                            }
                            phi_1163_ = select(_e681, (_e681 + 1u), _e689);
                        } else {
                            phi_1163_ = u32();
                        }
                        let _e695 = phi_1163_;
                        continue;
                        continuing {
                            phi_1159_ = type_9(select(_e628.member, (_e628.member + 1u), _e633), select(_e628.member_1, _e628.member_1, _e633));
                            phi_1162_ = _e695;
                            break if !(_e646);
                        }
                    }
                    workgroupBarrier();
                    let _e698 = n_hits[0u];
                    let _e699 = (_e698 - _e617);
                    phi_1282_ = type_9(0u, 4u);
                    phi_1285_ = 0u;
                    loop {
                        let _e703 = phi_1282_;
                        let _e705 = phi_1285_;
                        local_7 = _e705;
                        local_8 = _e705;
                        let _e708 = (_e703.member < _e703.member_1);
                        let _e719 = select(type_9().member_1, _e703.member, _e708);
                        if (bitcast<i32>(select(0u, 1u, _e708)) != 0i) {
                            let _e723 = (_e55 + (_e719 * 128u));
                            if (_e723 >= select(_e699, 512u, (512u < _e699))) {
                                phi_2657_ = u32();
                                phi_2658_ = false;
                            } else {
                                let _e726 = hits[_e723];
                                let _e729 = ((_e726 >> bitcast<u32>(10i)) & 3u);
                                let _e737 = names[((_e729 * 32u) + (_e726 & 31u))];
                                let _e740 = firsts[(2u * _e729)];
                                let _e741 = (_e740 + ((_e726 >> bitcast<u32>(5i)) & 31u));
                                let _e745 = firsts[((2u * _e729) + 1u)];
                                let _e746 = (_e745 + _e737);
                                if ((_e111.member_1 & 512u) != 0u) {
                                    let _e752 = ends.member[(((_e741 / 32u) * 96u) + (_e741 % 32u))];
                                    let _e760 = ends.member[(((((_e741 / 32u) * 3u) + 1u) * 32u) + (_e741 % 32u))];
                                    let _e776 = ends.member[(((((_e741 / 32u) * 3u) + 2u) * 32u) + (_e741 % 32u))];
                                    let _e786 = ends.member[(((_e746 / 32u) * 96u) + (_e746 % 32u))];
                                    let _e794 = ends.member[(((((_e746 / 32u) * 3u) + 1u) * 32u) + (_e746 % 32u))];
                                    let _e810 = ends.member[(((((_e746 / 32u) * 3u) + 2u) * 32u) + (_e746 % 32u))];
                                    phi_1502_ = !(((((((_e752.x - _e786.w) > _e124) && ((_e760.z - _e810.y) > _e124)) || (((_e786.x - _e752.w) > _e124) && ((_e794.z - _e776.y) > _e124))) || ((((_e752.y - _e794.x) > _e124) && ((_e760.w - _e810.z) > _e124)) || (((_e786.y - _e760.x) > _e124) && ((_e794.w - _e776.z) > _e124)))) || ((((_e752.z - _e794.y) > _e124) && ((_e776.x - _e810.w) > _e124)) || (((_e786.z - _e760.y) > _e124) && ((_e810.x - _e776.w) > _e124)))));
                                } else {
                                    phi_1502_ = true;
                                }
                                let _e852 = phi_1502_;
                                if _e852 {
                                    phi_1578_ = true;
                                } else {
                                    if ((_e111.member_1 & 2u) != 0u) {
                                        phi_1573_ = false;
                                    } else {
                                        if ((_e111.member_1 & 32u) != 0u) {
                                            let _e860 = nodes.member[_e741];
                                            let _e874 = nodes.member[_e746];
                                            phi_1572_ = (((((_e860.member_1.y - _e874.member.x) > _e111.member_6) && ((_e874.member_1.y - _e860.member.x) > _e111.member_6)) && (((_e860.member_2.x - _e874.member.y) > _e111.member_6) && ((_e874.member_2.x - _e860.member.y) > _e111.member_6))) && (((_e860.member_2.y - _e874.member_1.x) > _e111.member_6) && ((_e874.member_2.y - _e860.member_1.x) > _e111.member_6)));
                                        } else {
                                            phi_1572_ = true;
                                        }
                                        let _e906 = phi_1572_;
                                        phi_1573_ = _e906;
                                    }
                                    let _e908 = phi_1573_;
                                    phi_1578_ = select(true, false, _e908);
                                }
                                let _e911 = phi_1578_;
                                if _e911 {
                                    let _e913 = leaves.member[_e741];
                                    let _e919 = leaves.member[_e746];
                                    if ((_e111.member_1 & 32u) != 0u) {
                                        let _e928 = nodes.member[_e741];
                                        let _e945 = nodes.member[_e746];
                                        phi_1664_ = array<type_29, 2>(type_29(array<f32, 3>(_e928.member.x, _e928.member.y, _e928.member_1.x), array<f32, 3>(_e928.member_1.y, _e928.member_2.x, _e928.member_2.y)), type_29(array<f32, 3>(_e945.member.x, _e945.member.y, _e945.member_1.x), array<f32, 3>(_e945.member_1.y, _e945.member_2.x, _e945.member_2.y)));
                                    } else {
                                        phi_1664_ = array<type_29, 2>(type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)), type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)));
                                    }
                                    let _e963 = phi_1664_;
                                    if ((_e111.member_1 & 1u) != 0u) {
                                        if (_e114 == 0u) {
                                            phi_1708_ = ((select((_e919.x == _e913.x), true, (_e919.x == _e913.x)) || select((_e919.y == _e913.x), true, (_e919.y == _e913.x))) || select((_e919.z == _e913.x), true, (_e919.z == _e913.x)));
                                        } else {
                                            phi_1708_ = (select((_e919.x == _e913.y), true, (_e919.x == _e913.x)) || select((_e919.y == _e913.y), true, (_e919.y == _e913.x)));
                                        }
                                        let _e987 = phi_1708_;
                                        phi_1709_ = _e987;
                                    } else {
                                        phi_1709_ = false;
                                    }
                                    let _e989 = phi_1709_;
                                    if _e989 {
                                        phi_2634_ = false;
                                        phi_2635_ = true;
                                    } else {
                                        if ((_e111.member_1 & 2u) != 0u) {
                                            let _e994 = bodies.member[_e913.x];
                                            let _e996 = bodies.member[_e919.x];
                                            if select(false, (((_e994 & _e996) & 1u) == 0u), select(select(true, false, ((_e994 & 2u) == 0u)), true, ((_e994 / 4u) != (_e996 / 4u)))) {
                                                if ((_e111.member_1 & 4u) != 0u) {
                                                    let _e1014 = bodies.member[_e111.member[0]];
                                                    let _e1017 = bodies.member[(_e111.member[0] + 1u)];
                                                    let _e1022 = ((_e111.member[0] + 4u) + (2u * (_e994 >> bitcast<u32>(2i))));
                                                    let _e1027 = ((_e111.member[0] + 4u) + (2u * (_e996 >> bitcast<u32>(2i))));
                                                    let _e1029 = bodies.member[_e1022];
                                                    let _e1031 = bodies.member[_e1027];
                                                    let _e1040 = bodies.member[((((_e111.member[0] + 4u) + (2u * _e1014)) + (_e1029 * _e1017)) + (_e1031 / 32u))];
                                                    let _e1043 = bodies.member[(_e1022 + 1u)];
                                                    let _e1046 = bodies.member[(_e1027 + 1u)];
                                                    if (_e1043 == _e1046) {
                                                        phi_1873_ = select(((_e994 >> bitcast<u32>(2i)) == (_e996 >> bitcast<u32>(2i))), true, (((_e1040 >> bitcast<u32>(((_e1031 % 32u) & 31u))) & 1u) == 1u));
                                                    } else {
                                                        phi_1873_ = false;
                                                    }
                                                    let _e1061 = phi_1873_;
                                                    if _e1061 {
                                                        let _e1064 = bodies.member[(_e111.member[0] + 2u)];
                                                        let _e1067 = bodies.member[(_e111.member[0] + 3u)];
                                                        let _e1068 = (_e1067 + _e111.member[0]);
                                                        let _e1069 = (_e114 == 1u);
                                                        let _e1070 = (_e919.w < _e913.w);
                                                        let _e1073 = select(_e919.w, select(_e919.w, _e913.w, _e1070), _e1069);
                                                        let _e1074 = select(_e913.w, select(_e913.w, _e919.w, _e1070), _e1069);
                                                        phi_1914_ = type_15(0i, 32i);
                                                        phi_1917_ = 0u;
                                                        loop {
                                                            let _e1076 = phi_1914_;
                                                            let _e1078 = phi_1917_;
                                                            local_2 = _e1078;
                                                            local_3 = _e1078;
                                                            if (_e1076.member < _e1076.member_1) {
                                                                let _e1085 = (_e1076.member + 1i);
                                                                phi_1915_ = type_15(select(_e1085, type_16().member_1, select(false, true, ((false == (_e1085 > _e1076.member)) != false))), _e1076.member_1);
                                                                phi_1958_ = type_16(1u, _e1076.member);
                                                            } else {
                                                                phi_1915_ = _e1076;
                                                                phi_1958_ = type_16(0u, type_16().member_1);
                                                            }
                                                            let _e1096 = phi_1915_;
                                                            let _e1098 = phi_1958_;
                                                            let _e1102 = (bitcast<i32>(_e1098.member) != 0i);
                                                            if _e1102 {
                                                                let _e1107 = (_e1078 | (1u << bitcast<u32>(((31i - _e1098.member_1) & 31i))));
                                                                if (_e1107 <= _e1064) {
                                                                    let _e1111 = (_e1068 + (3u * (_e1107 - 1u)));
                                                                    let _e1113 = bodies.member[_e1111];
                                                                    let _e1116 = bodies.member[(_e1111 + 1u)];
                                                                    let _e1119 = bodies.member[(_e1111 + 2u)];
                                                                    phi_2037_ = select(_e1078, _e1107, select(select(false, select(select(false, (_e1119 < _e1073), (_e1116 == _e1074)), true, (_e1116 < _e1074)), (_e1113 == _e114)), true, (_e1113 < _e114)));
                                                                } else {
                                                                    phi_2037_ = _e1078;
                                                                }
                                                                let _e1131 = phi_2037_;
                                                                phi_1918_ = _e1131;
                                                            } else {
                                                                phi_1918_ = u32();
                                                            }
                                                            let _e1133 = phi_1918_;
                                                            continue;
                                                            continuing {
                                                                phi_1914_ = _e1096;
                                                                phi_1917_ = _e1133;
                                                                break if !(_e1102);
                                                            }
                                                        }
                                                        let _e1136 = local_2;
                                                        if (_e1136 < _e1064) {
                                                            let _e1139 = local_3;
                                                            let _e1141 = (_e1068 + (3u * _e1139));
                                                            let _e1143 = bodies.member[_e1141];
                                                            if (_e1143 == _e114) {
                                                                let _e1147 = bodies.member[(_e1141 + 1u)];
                                                                if (_e1147 == _e1074) {
                                                                    let _e1151 = bodies.member[(_e1141 + 2u)];
                                                                    phi_2085_ = (_e1151 == _e1073);
                                                                    phi_2086_ = false;
                                                                } else {
                                                                    phi_2085_ = bool();
                                                                    phi_2086_ = true;
                                                                }
                                                                let _e1154 = phi_2085_;
                                                                let _e1156 = phi_2086_;
                                                                phi_2087_ = _e1154;
                                                                phi_2088_ = _e1156;
                                                            } else {
                                                                phi_2087_ = bool();
                                                                phi_2088_ = true;
                                                            }
                                                            let _e1158 = phi_2087_;
                                                            let _e1160 = phi_2088_;
                                                            phi_2093_ = select(_e1158, false, _e1160);
                                                        } else {
                                                            phi_2093_ = false;
                                                        }
                                                        let _e1163 = phi_2093_;
                                                        phi_2097_ = _e1163;
                                                    } else {
                                                        phi_2097_ = true;
                                                    }
                                                    let _e1165 = phi_2097_;
                                                    phi_2102_ = select(true, false, _e1165);
                                                } else {
                                                    phi_2102_ = true;
                                                }
                                                let _e1168 = phi_2102_;
                                                phi_2107_ = select(true, false, _e1168);
                                            } else {
                                                phi_2107_ = true;
                                            }
                                            let _e1171 = phi_2107_;
                                            phi_2112_ = select(true, false, _e1171);
                                        } else {
                                            phi_2112_ = true;
                                        }
                                        let _e1174 = phi_2112_;
                                        if _e1174 {
                                            if ((_e111.member_1 & 32u) != 0u) {
                                                let _e1231 = (((((_e963[0].member_1[0] - _e963[1].member[0]) > _e111.member_6) && ((_e963[1].member_1[0] - _e963[0].member[0]) > _e111.member_6)) && (((_e963[0].member_1[1] - _e963[1].member[1]) > _e111.member_6) && ((_e963[1].member_1[1] - _e963[0].member[1]) > _e111.member_6))) && (((_e963[0].member_1[2] - _e963[1].member[2]) > _e111.member_6) && ((_e963[1].member_1[2] - _e963[0].member[2]) > _e111.member_6)));
                                                if _e1231 {
                                                    phi_2625_ = bool();
                                                } else {
                                                    phi_2157_ = type_9(0u, 3u);
                                                    loop {
                                                        let _e1233 = phi_2157_;
                                                        let _e1236 = (_e1233.member < _e1233.member_1);
                                                        let _e1247 = select(type_9().member_1, _e1233.member, _e1236);
                                                        if (bitcast<i32>(select(0u, 1u, _e1236)) != 0i) {
                                                            let _e1251 = ((6u * _e913.x) + _e1247);
                                                            let _e1254 = keys.member[(2u * _e1251)];
                                                            let _e1258 = keys.member[((2u * _e1251) + 1u)];
                                                            let _e1261 = ((6u * _e913.y) + _e1247);
                                                            let _e1264 = keys.member[(2u * _e1261)];
                                                            let _e1268 = keys.member[((2u * _e1261) + 1u)];
                                                            let _e1270 = function_1(array<u32, 2>(_e1254, _e1258), array<u32, 2>(_e1264, _e1268));
                                                            let _e1272 = ((6u * _e913.z) + _e1247);
                                                            let _e1275 = keys.member[(2u * _e1272)];
                                                            let _e1279 = keys.member[((2u * _e1272) + 1u)];
                                                            let _e1281 = function_1(_e1270, array<u32, 2>(_e1275, _e1279));
                                                            let _e1284 = (((6u * _e919.x) + 3u) + _e1247);
                                                            let _e1287 = keys.member[(2u * _e1284)];
                                                            let _e1291 = keys.member[((2u * _e1284) + 1u)];
                                                            let _e1295 = (((6u * _e919.y) + 3u) + _e1247);
                                                            let _e1298 = keys.member[(2u * _e1295)];
                                                            let _e1302 = keys.member[((2u * _e1295) + 1u)];
                                                            let _e1304 = function_(array<u32, 2>(_e1287, _e1291), array<u32, 2>(_e1298, _e1302));
                                                            let _e1307 = (((6u * _e919.z) + 3u) + _e1247);
                                                            let _e1310 = keys.member[(2u * _e1307)];
                                                            let _e1314 = keys.member[((2u * _e1307) + 1u)];
                                                            let _e1316 = function_(_e1304, array<u32, 2>(_e1310, _e1314));
                                                            let _e1327 = select(select(false, (_e1281[0] > _e1316[0]), (_e1281[1] == _e1316[1])), true, (_e1281[1] > _e1316[1]));
                                                            if _e1327 {
                                                                phi_2604_ = false;
                                                                phi_2605_ = false;
                                                            } else {
                                                                let _e1329 = ((6u * _e919.x) + _e1247);
                                                                let _e1332 = keys.member[(2u * _e1329)];
                                                                let _e1336 = keys.member[((2u * _e1329) + 1u)];
                                                                let _e1339 = ((6u * _e919.y) + _e1247);
                                                                let _e1342 = keys.member[(2u * _e1339)];
                                                                let _e1346 = keys.member[((2u * _e1339) + 1u)];
                                                                let _e1348 = function_1(array<u32, 2>(_e1332, _e1336), array<u32, 2>(_e1342, _e1346));
                                                                let _e1350 = ((6u * _e919.z) + _e1247);
                                                                let _e1353 = keys.member[(2u * _e1350)];
                                                                let _e1357 = keys.member[((2u * _e1350) + 1u)];
                                                                let _e1359 = function_1(_e1348, array<u32, 2>(_e1353, _e1357));
                                                                let _e1362 = (((6u * _e913.x) + 3u) + _e1247);
                                                                let _e1365 = keys.member[(2u * _e1362)];
                                                                let _e1369 = keys.member[((2u * _e1362) + 1u)];
                                                                let _e1373 = (((6u * _e913.y) + 3u) + _e1247);
                                                                let _e1376 = keys.member[(2u * _e1373)];
                                                                let _e1380 = keys.member[((2u * _e1373) + 1u)];
                                                                let _e1382 = function_(array<u32, 2>(_e1365, _e1369), array<u32, 2>(_e1376, _e1380));
                                                                let _e1385 = (((6u * _e913.z) + 3u) + _e1247);
                                                                let _e1388 = keys.member[(2u * _e1385)];
                                                                let _e1392 = keys.member[((2u * _e1385) + 1u)];
                                                                let _e1394 = function_(_e1382, array<u32, 2>(_e1388, _e1392));
                                                                let _e1405 = select(select(false, (_e1359[0] > _e1394[0]), (_e1359[1] == _e1394[1])), true, (_e1359[1] > _e1394[1]));
                                                                phi_2604_ = select(true, false, _e1405);
                                                                phi_2605_ = _e1405;
                                                            }
                                                            let _e1408 = phi_2604_;
                                                            let _e1410 = phi_2605_;
                                                            phi_2606_ = _e1408;
                                                            phi_2607_ = _e1327;
                                                            phi_2608_ = _e1410;
                                                        } else {
                                                            phi_2606_ = false;
                                                            phi_2607_ = false;
                                                            phi_2608_ = false;
                                                        }
                                                        let _e1412 = phi_2606_;
                                                        let _e1414 = phi_2607_;
                                                        let _e1416 = phi_2608_;
                                                        local_4 = _e1414;
                                                        local_5 = _e1416;
                                                        local_6 = _e1414;
                                                        continue;
                                                        continuing {
                                                            phi_2157_ = type_9(select(_e1233.member, (_e1233.member + 1u), _e1236), select(_e1233.member_1, _e1233.member_1, _e1236));
                                                            break if !(_e1412);
                                                        }
                                                    }
                                                    let _e1419 = local_4;
                                                    let _e1421 = local_5;
                                                    let _e1424 = local_6;
                                                    phi_2625_ = select(false, true, select(true, false, select(_e1424, true, select(_e1421, false, _e1419))));
                                                }
                                                let _e1429 = phi_2625_;
                                                phi_2626_ = _e1429;
                                                phi_2627_ = _e1231;
                                            } else {
                                                phi_2626_ = bool();
                                                phi_2627_ = true;
                                            }
                                            let _e1431 = phi_2626_;
                                            let _e1433 = phi_2627_;
                                            phi_2632_ = _e1431;
                                            phi_2633_ = select(true, false, _e1433);
                                        } else {
                                            phi_2632_ = false;
                                            phi_2633_ = true;
                                        }
                                        let _e1436 = phi_2632_;
                                        let _e1438 = phi_2633_;
                                        phi_2634_ = _e1436;
                                        phi_2635_ = _e1438;
                                    }
                                    let _e1440 = phi_2634_;
                                    let _e1442 = phi_2635_;
                                    let _e1443 = select(true, _e1440, _e1442);
                                    if _e1443 {
                                    } else {
                                        let _e1445 = atomicAdd((&counters[7u]), 4294967295u);
                                    }
                                    phi_2656_ = select(_e705, select(_e705, (_e705 | (1u << bitcast<u32>((_e719 & 31u)))), _e852), _e1443);
                                } else {
                                    phi_2656_ = _e705;
                                }
                                let _e1453 = phi_2656_;
                                phi_2657_ = _e1453;
                                phi_2658_ = true;
                            }
                            let _e1455 = phi_2657_;
                            let _e1457 = phi_2658_;
                            phi_1286_ = _e1455;
                            phi_2659_ = _e1457;
                        } else {
                            phi_1286_ = u32();
                            phi_2659_ = false;
                        }
                        let _e1459 = phi_1286_;
                        let _e1461 = phi_2659_;
                        continue;
                        continuing {
                            phi_1282_ = type_9(select(_e703.member, (_e703.member + 1u), _e708), select(_e703.member_1, _e703.member_1, _e708));
                            phi_1285_ = _e1459;
                            break if !(_e1461);
                        }
                    }
                    let _e1465 = params.member.member_1.member_3;
                    let _e1467 = local_7;
                    let _e1470 = atomicAdd((&counters[5u]), countOneBits(_e1467));
                    workgroupBarrier();
                    if (_e55 == 0u) {
                        let _e1473 = atomicLoad((&counters[5u]));
                        if (_e1473 > 0u) {
                            let _e1477 = params.member.member.member_1;
                            if ((_e1477 & 1024u) != 0u) {
                                let _e1487 = atomicAdd((&output.member[0u]), _e1473);
                                let _e1488 = (_e1487 + _e1473);
                                let _e1490 = select(_e1488, 4294967295u, (_e1488 < _e1487));
                                let _e1493 = params.member.member_1.member_3;
                                if (_e1490 > _e1493) {
                                    let _e1496 = atomicMax((&output.member[2u]), _e1490);
                                }
                                phi_2718_ = _e1487;
                            } else {
                                let _e1481 = atomicAdd((&output.member[0u]), _e1473);
                                if ((_e1481 + _e1473) < _e1481) {
                                    let _e1485 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_2718_ = _e1481;
                            }
                            let _e1498 = phi_2718_;
                            atomicStore((&counters[6u]), _e1498);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e1502 = atomicLoad((&counters[6u]));
                    phi_2726_ = type_9(0u, 4u);
                    phi_2729_ = (_e1470 + _e1502);
                    loop {
                        let _e1505 = phi_2726_;
                        let _e1507 = phi_2729_;
                        let _e1510 = (_e1505.member < _e1505.member_1);
                        let _e1521 = select(type_9().member_1, _e1505.member, _e1510);
                        let _e1523 = (bitcast<i32>(select(0u, 1u, _e1510)) != 0i);
                        if _e1523 {
                            let _e1526 = local_8;
                            if (((_e1526 >> bitcast<u32>((_e1521 & 31u))) & 1u) == 1u) {
                                let _e1534 = hits[(_e55 + (_e1521 * 128u))];
                                let _e1537 = ((_e1534 >> bitcast<u32>(10i)) & 3u);
                                let _e1545 = names[((_e1537 * 32u) + (_e1534 & 31u))];
                                let _e1548 = firsts[(2u * _e1537)];
                                let _e1553 = firsts[((2u * _e1537) + 1u)];
                                let _e1556 = leaves.member[(_e1548 + ((_e1534 >> bitcast<u32>(5i)) & 31u))];
                                let _e1559 = leaves.member[(_e1553 + _e1545)];
                                if (_e114 == 1u) {
                                    let _e1563 = (_e1556.w < _e1559.w);
                                    phi_2827_ = type_9(select(_e1559.w, _e1556.w, _e1563), select(_e1556.w, _e1559.w, _e1563));
                                } else {
                                    phi_2827_ = type_9(_e1556.w, _e1559.w);
                                }
                                let _e1568 = phi_2827_;
                                if (_e1507 < _e1465) {
                                    let _e1572 = (2u * _e1507);
                                    atomicStore((&output.member[(4u + _e1572)]), _e1568.member);
                                    atomicStore((&output.member[(_e1572 + 5u)]), _e1568.member_1);
                                }
                                phi_2842_ = (_e1507 + 1u);
                            } else {
                                phi_2842_ = _e1507;
                            }
                            let _e1579 = phi_2842_;
                            phi_2730_ = _e1579;
                        } else {
                            phi_2730_ = u32();
                        }
                        let _e1581 = phi_2730_;
                        continue;
                        continuing {
                            phi_2726_ = type_9(select(_e1505.member, (_e1505.member + 1u), _e1510), select(_e1505.member_1, _e1505.member_1, _e1510));
                            phi_2729_ = _e1581;
                            break if !(_e1523);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1097_ = type_9(select(_e593.member, (_e593.member + 1u), _e596), select(_e593.member_1, _e593.member_1, _e596));
                    break if !(_e609);
                }
            }
            phi_281_ = (_e128 + (_e54.x * _e54.y));
        } else {
            phi_281_ = u32();
        }
        let _e1585 = phi_281_;
        continue;
        continuing {
            phi_280_ = _e1585;
            break if !(_e134);
        }
    }
    if (_e55 == 0u) {
        let _e1589 = atomicLoad((&counters[7u]));
        if (_e1589 > 0u) {
            let _e1592 = atomicAdd((&output.member[1u]), _e1589);
            if ((_e1592 + _e1589) < _e1592) {
                let _e1596 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_wanted(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
