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

struct type_32 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> output: type_32;
var<workgroup> ranges: array<u32, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_205_: u32;
    var phi_253_: u32;
    var phi_256_: type_9;
    var phi_328_: u32;
    var phi_431_: type_9;
    var phi_434_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_527_: type_9;
    var phi_530_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_786_: bool;
    var phi_824_: type_24;
    var phi_859_: type_9;
    var phi_862_: u32;
    var phi_863_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1104_: type_9;
    var phi_1107_: u32;
    var phi_1108_: u32;
    var phi_1172_: u32;
    var phi_1173_: u32;
    var phi_1177_: type_9;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var local_11: u32;
    var phi_1294_: type_9;
    var phi_1356_: type_9;
    var phi_1359_: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var phi_1360_: u32;
    var phi_1533_: u32;
    var phi_1540_: type_9;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var local_16: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e42 = id_2;
    let _e43 = n_2;
    let _e44 = lane_2;
    let _e54 = ((_e42.y * _e43.x) + _e42.x);
    let _e57 = (_e43.x * _e43.y);
    let _e61 = params.member.member_1.member_2;
    let _e63 = input.member[0u];
    let _e65 = select(_e63, _e61, (_e61 < _e63));
    let _e66 = (_e44 / 32u);
    let _e67 = (_e44 % 32u);
    let _e70 = params.member.member_1.member_1;
    if (_e65 > _e70) {
        let _e74 = params.member.member_1.member_1;
        let _e75 = (_e65 - _e74);
        let _e78 = params.member.member_2.member_3;
        if (_e78 == 0u) {
            return;
        }
        let _e80 = (_e75 / _e78);
        if (_e78 == 0u) {
            return;
        }
        phi_205_ = select(_e80, (_e80 + 1u), ((_e75 % _e78) > 0u));
    } else {
        phi_205_ = 0u;
    }
    let _e87 = phi_205_;
    let _e90 = params.member.member_2.member_4;
    let _e92 = select(_e87, _e90, (_e90 < _e87));
    let _e93 = (_e92 / 4u);
    let _e97 = select(_e93, (_e93 + 1u), ((_e92 % 4u) > 0u));
    if (_e97 > _e54) {
        let _e99 = (_e97 - _e54);
        if (_e57 == 0u) {
            return;
        }
        let _e101 = (_e99 / _e57);
        if (_e57 == 0u) {
            return;
        }
        phi_253_ = select(_e101, (_e101 + 1u), ((_e99 % _e57) > 0u));
    } else {
        phi_253_ = 0u;
    }
    let _e108 = phi_253_;
    phi_256_ = type_9(0u, _e108);
    loop {
        let _e111 = phi_256_;
        let _e114 = (_e111.member < _e111.member_1);
        let _e127 = (bitcast<i32>(select(0u, 1u, _e114)) != 0i);
        if _e127 {
            let _e132 = (((_e54 + (select(type_9().member_1, _e111.member, _e114) * _e57)) * 4u) + (_e44 / 32u));
            let _e135 = params.member.member_1.member_1;
            if (_e65 > _e135) {
                let _e139 = params.member.member_1.member_1;
                let _e140 = (_e65 - _e139);
                let _e143 = params.member.member_2.member_3;
                if (_e143 == 0u) {
                    return;
                }
                let _e145 = (_e140 / _e143);
                if (_e143 == 0u) {
                    return;
                }
                phi_328_ = select(_e145, (_e145 + 1u), ((_e140 % _e143) > 0u));
            } else {
                phi_328_ = 0u;
            }
            let _e152 = phi_328_;
            let _e155 = params.member.member_2.member_4;
            let _e158 = (_e132 < select(_e152, _e155, (_e155 < _e152)));
            let _e161 = params.member.member_1.member_1;
            let _e164 = params.member.member_2.member_3;
            let _e168 = (2u * (_e161 + select(0u, (_e132 * _e164), _e158)));
            let _e171 = input.member[(4u + _e168)];
            let _e174 = input.member[(_e168 + 5u)];
            if (_e44 <= 5u) {
                atomicStore((&counters[_e44]), 0u);
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                firsts[(2u * _e66)] = (_e171 * 32u);
                firsts[((2u * _e66) + 1u)] = (_e174 * 32u);
            }
            let _e187 = params.member.member_2.member_1;
            let _e188 = (_e187 == 0u);
            let _e189 = select(1u, 0u, _e188);
            let _e190 = select(1u, 2u, _e188);
            let _e193 = params.member.member_2.member_2;
            let _e194 = (_e193 - 1u);
            let _e197 = params.member.member.member;
            local = array<u32, 3>(_e197[0], _e197[1], _e197[2]);
            let _e203 = ((_e171 * 32u) + _e67);
            let _e205 = local[_e189];
            phi_431_ = type_9(0u, _e194);
            phi_434_ = 1u;
            loop {
                let _e208 = phi_431_;
                let _e210 = phi_434_;
                local_1 = _e210;
                local_2 = _e210;
                local_3 = _e210;
                local_4 = _e210;
                let _e213 = (_e208.member < _e208.member_1);
                let _e224 = (bitcast<i32>(select(0u, 1u, _e213)) != 0i);
                continue;
                continuing {
                    phi_431_ = type_9(select(_e208.member, (_e208.member + 1u), _e213), select(_e208.member_1, _e208.member_1, _e213));
                    phi_434_ = select(u32(), (_e210 * 32u), _e224);
                    break if !(_e224);
                }
            }
            let _e230 = local_1;
            if (_e230 == 0u) {
                return;
            }
            let _e233 = local_2;
            let _e234 = ((_e205 - 1u) / _e233);
            let _e238 = local_3;
            let _e239 = (select(_e203, _e234, (_e234 < _e203)) * _e238);
            let _e241 = local_4;
            let _e243 = (_e239 + (_e241 - 1u));
            let _e244 = (_e205 - 1u);
            let _e250 = params.member.member_2.member[0u][_e189];
            let _e253 = worlds.member[(_e250 + _e239)];
            let _e258 = worlds.member[(_e250 + select(_e243, _e244, (_e244 < _e243)))];
            let _e259 = ((_e253 << bitcast<u32>(16i)) | _e258);
            let _e261 = ((_e174 * 32u) + _e67);
            let _e263 = local[_e190];
            phi_527_ = type_9(0u, _e194);
            phi_530_ = 1u;
            loop {
                let _e266 = phi_527_;
                let _e268 = phi_530_;
                local_5 = _e268;
                local_6 = _e268;
                local_7 = _e268;
                local_8 = _e268;
                let _e271 = (_e266.member < _e266.member_1);
                let _e282 = (bitcast<i32>(select(0u, 1u, _e271)) != 0i);
                continue;
                continuing {
                    phi_527_ = type_9(select(_e266.member, (_e266.member + 1u), _e271), select(_e266.member_1, _e266.member_1, _e271));
                    phi_530_ = select(u32(), (_e268 * 32u), _e282);
                    break if !(_e282);
                }
            }
            let _e288 = local_5;
            if (_e288 == 0u) {
                return;
            }
            let _e291 = local_6;
            let _e292 = ((_e263 - 1u) / _e291);
            let _e296 = local_7;
            let _e297 = (select(_e261, _e292, (_e292 < _e261)) * _e296);
            let _e299 = local_8;
            let _e301 = (_e297 + (_e299 - 1u));
            let _e302 = (_e263 - 1u);
            let _e308 = params.member.member_2.member[0u][_e190];
            let _e311 = worlds.member[(_e308 + _e297)];
            let _e316 = worlds.member[(_e308 + select(_e301, _e302, (_e302 < _e301)))];
            ranges[_e44] = ((_e311 << bitcast<u32>(16i)) | _e316);
            let _e321 = params.member.member_2.member_1;
            let _e322 = (_e321 == 0u);
            let _e323 = select(1u, 0u, _e322);
            let _e324 = select(1u, 2u, _e322);
            let _e325 = (_e44 / 32u);
            let _e326 = (_e44 % 32u);
            let _e328 = params.member.member_2.member_2;
            let _e332 = params.member.member_2.member[_e328][_e323];
            let _e335 = nodes.member[(_e332 + _e171)];
            let _e349 = params.member.member_2.member_2;
            let _e353 = params.member.member_2.member[_e349][_e324];
            let _e356 = nodes.member[(_e353 + _e174)];
            let _e370 = params.member.member_2.member_2;
            let _e377 = params.member.member_2.member[(_e370 - 1u)][_e323];
            let _e380 = nodes.member[(_e377 + ((_e171 * 32u) + _e326))];
            let _e397 = params.member.member_2.member_2;
            let _e404 = params.member.member_2.member[(_e397 - 1u)][_e324];
            let _e407 = nodes.member[(_e404 + ((_e174 * 32u) + _e326))];
            if _e158 {
                phi_786_ = ((((((_e380.member.x <= _e356.member_1.y) && (_e356.member.x <= _e380.member_1.y)) && (_e380.member.y <= _e356.member_2.x)) && (_e356.member.y <= _e380.member_2.x)) && (_e380.member_1.x <= _e356.member_2.y)) && (_e356.member_1.x <= _e380.member_2.y));
            } else {
                phi_786_ = false;
            }
            let _e432 = phi_786_;
            if _e158 {
                if ((((((_e407.member.x <= _e335.member_1.y) && (_e335.member.x <= _e407.member_1.y)) && (_e407.member.y <= _e335.member_2.x)) && (_e335.member.y <= _e407.member_2.x)) && (_e407.member_1.x <= _e335.member_2.y)) && (_e335.member_1.x <= _e407.member_2.y)) {
                    let _e446 = atomicAdd((&counters[_e325]), 1u);
                    let _e447 = ((_e325 * 32u) + _e446);
                    columns[_e447] = type_24(array<f32, 3>(_e407.member.x, _e407.member.y, _e407.member_1.x), array<f32, 3>(_e407.member_1.y, _e407.member_2.x, _e407.member_2.y));
                    names[_e447] = _e326;
                }
            }
            if _e432 {
                phi_824_ = type_24(array<f32, 3>(_e380.member.x, _e380.member.y, _e380.member_1.x), array<f32, 3>(_e380.member_1.y, _e380.member_2.x, _e380.member_2.y));
            } else {
                phi_824_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e454 = phi_824_;
            workgroupBarrier();
            let _e457 = params.member.member_2.member_1;
            let _e460 = select(false, (_e171 == _e174), (_e457 == 1u));
            let _e461 = (_e44 / 32u);
            let _e462 = (_e44 % 32u);
            let _e463 = (_e461 * 32u);
            let _e465 = atomicLoad((&counters[_e461]));
            let _e466 = (_e465 / 4u);
            phi_859_ = type_9(0u, select(_e466, (_e466 + 1u), ((_e465 % 4u) > 0u)));
            phi_862_ = 0u;
            loop {
                let _e473 = phi_859_;
                let _e475 = phi_862_;
                local_9 = _e475;
                local_10 = _e475;
                let _e478 = (_e473.member < _e473.member_1);
                let _e491 = (bitcast<i32>(select(0u, 1u, _e478)) != 0i);
                if _e491 {
                    let _e492 = (4u * select(type_9().member_1, _e473.member, _e478));
                    let _e495 = columns[(_e463 + _e492)];
                    let _e534 = columns[((_e463 + _e492) + 1u)];
                    let _e575 = columns[((_e463 + _e492) + 2u)];
                    let _e616 = columns[((_e463 + _e492) + 3u)];
                    phi_863_ = (_e475 | ((((select(0u, 1u, ((((((_e454.member[0] <= _e495.member_1[0]) && (_e495.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e495.member_1[1])) && (_e495.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e495.member_1[2])) && (_e495.member[2] <= _e454.member_1[2]))) << bitcast<u32>((_e492 & 31u))) | (select(0u, 1u, ((((((_e454.member[0] <= _e534.member_1[0]) && (_e534.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e534.member_1[1])) && (_e534.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e534.member_1[2])) && (_e534.member[2] <= _e454.member_1[2]))) << bitcast<u32>(((_e492 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e454.member[0] <= _e575.member_1[0]) && (_e575.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e575.member_1[1])) && (_e575.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e575.member_1[2])) && (_e575.member[2] <= _e454.member_1[2]))) << bitcast<u32>(((_e492 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e454.member[0] <= _e616.member_1[0]) && (_e616.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e616.member_1[1])) && (_e616.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e616.member_1[2])) && (_e616.member[2] <= _e454.member_1[2]))) << bitcast<u32>(((_e492 + 3u) & 31u)))));
                } else {
                    phi_863_ = u32();
                }
                let _e656 = phi_863_;
                continue;
                continuing {
                    phi_859_ = type_9(select(_e473.member, (_e473.member + 1u), _e478), select(_e473.member_1, _e473.member_1, _e478));
                    phi_862_ = _e656;
                    break if !(_e491);
                }
            }
            let _e664 = local_9;
            let _e667 = local_10;
            let _e668 = select(_e667, (_e664 & ((1u << bitcast<u32>((_e465 & 31u))) - 1u)), (_e465 < 32u));
            let _e671 = params.member.member.member_1;
            if ((_e671 & 256u) != 0u) {
                if select(!((_e454.member[0] <= _e454.member_1[0])), true, ((bitcast<u32>(_e454.member_1[0]) & 1u) == 1u)) {
                    phi_1104_ = type_9(0u, _e465);
                    phi_1107_ = _e668;
                    loop {
                        let _e688 = phi_1104_;
                        let _e690 = phi_1107_;
                        local_16 = _e690;
                        let _e693 = (_e688.member < _e688.member_1);
                        let _e704 = select(type_9().member_1, _e688.member, _e693);
                        let _e706 = (bitcast<i32>(select(0u, 1u, _e693)) != 0i);
                        if _e706 {
                            let _e709 = columns[(_e463 + _e704)];
                            phi_1108_ = select(_e690, (_e690 & ~((1u << bitcast<u32>((_e704 & 31u))))), select(!((_e709.member[0] <= _e709.member_1[0])), true, ((bitcast<u32>(_e709.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_1108_ = u32();
                        }
                        let _e727 = phi_1108_;
                        continue;
                        continuing {
                            phi_1104_ = type_9(select(_e688.member, (_e688.member + 1u), _e693), select(_e688.member_1, _e688.member_1, _e693));
                            phi_1107_ = _e727;
                            break if !(_e706);
                        }
                    }
                    let _e1044 = local_16;
                    phi_1172_ = _e1044;
                } else {
                    phi_1172_ = _e668;
                }
                let _e730 = phi_1172_;
                phi_1173_ = _e730;
            } else {
                phi_1173_ = _e668;
            }
            let _e732 = phi_1173_;
            phi_1177_ = type_9(0u, _e465);
            phi_1180_ = _e732;
            loop {
                let _e735 = phi_1177_;
                let _e737 = phi_1180_;
                local_11 = _e737;
                local_12 = _e737;
                local_13 = _e737;
                local_14 = _e737;
                local_15 = _e737;
                let _e740 = (_e735.member < _e735.member_1);
                let _e751 = select(type_9().member_1, _e735.member, _e740);
                let _e753 = (bitcast<i32>(select(0u, 1u, _e740)) != 0i);
                if _e753 {
                    let _e756 = names[(_e463 + _e751)];
                    let _e759 = ranges[(_e463 + _e756)];
                    let _e769 = (_e462 < _e756);
                    phi_1181_ = select(_e737, (_e737 & ~((1u << bitcast<u32>((_e751 & 31u))))), select(true, select(true, false, select(false, ((_e759 >> bitcast<u32>(16i)) <= (_e259 & 65535u)), ((_e259 >> bitcast<u32>(16i)) <= (_e759 & 65535u)))), select(select(bool(), select(select(false, true, (_e462 == _e756)), bool(), _e769), _e460), true, select(true, _e769, _e460))));
                } else {
                    phi_1181_ = u32();
                }
                let _e785 = phi_1181_;
                continue;
                continuing {
                    phi_1177_ = type_9(select(_e735.member, (_e735.member + 1u), _e740), select(_e735.member_1, _e735.member_1, _e740));
                    phi_1180_ = _e785;
                    break if !(_e753);
                }
            }
            let _e788 = local_11;
            let _e791 = atomicAdd((&counters[4u]), countOneBits(_e788));
            workgroupBarrier();
            if (_e44 == 0u) {
                let _e794 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e794;
            }
            let _e797 = workgroupUniformLoad((&n_hits[0u]));
            let _e798 = (_e797 / 512u);
            phi_1294_ = type_9(0u, select(_e798, (_e798 + 1u), ((_e797 % 512u) > 0u)));
            loop {
                let _e805 = phi_1294_;
                let _e808 = (_e805.member < _e805.member_1);
                let _e821 = (bitcast<i32>(select(0u, 1u, _e808)) != 0i);
                if _e821 {
                    let _e822 = (_e44 / 32u);
                    let _e828 = ((_e822 << bitcast<u32>(10i)) | ((_e44 % 32u) << bitcast<u32>(5i)));
                    let _e829 = (select(type_9().member_1, _e805.member, _e808) * 512u);
                    let _e832 = atomicLoad((&counters[_e822]));
                    let _e833 = (_e832 / 4u);
                    phi_1356_ = type_9(0u, select(_e833, (_e833 + 1u), ((_e832 % 4u) > 0u)));
                    phi_1359_ = (_e791 - _e829);
                    loop {
                        let _e840 = phi_1356_;
                        let _e842 = phi_1359_;
                        let _e845 = (_e840.member < _e840.member_1);
                        let _e858 = (bitcast<i32>(select(0u, 1u, _e845)) != 0i);
                        if _e858 {
                            let _e859 = (4u * select(type_9().member_1, _e840.member, _e845));
                            let _e863 = local_12;
                            let _e867 = (((_e863 >> bitcast<u32>((_e859 & 31u))) & 1u) == 1u);
                            if _e867 {
                                if (_e842 < 512u) {
                                    hits[_e842] = (_e828 + _e859);
                                }
                            }
                            let _e871 = select(_e842, (_e842 + 1u), _e867);
                            let _e877 = local_13;
                            let _e881 = (((_e877 >> bitcast<u32>(((_e859 + 1u) & 31u))) & 1u) == 1u);
                            if _e881 {
                                if (_e871 < 512u) {
                                    hits[_e871] = ((_e828 + _e859) + 1u);
                                }
                            }
                            let _e885 = select(_e871, (_e871 + 1u), _e881);
                            let _e891 = local_14;
                            let _e895 = (((_e891 >> bitcast<u32>(((_e859 + 2u) & 31u))) & 1u) == 1u);
                            if _e895 {
                                if (_e885 < 512u) {
                                    hits[_e885] = ((_e828 + _e859) + 2u);
                                }
                            }
                            let _e899 = select(_e885, (_e885 + 1u), _e895);
                            let _e905 = local_15;
                            let _e909 = (((_e905 >> bitcast<u32>(((_e859 + 3u) & 31u))) & 1u) == 1u);
                            if _e909 {
                                if (_e899 < 512u) {
                                    hits[_e899] = ((_e828 + _e859) + 3u);
                                }
                            }
                            phi_1360_ = select(_e899, (_e899 + 1u), _e909);
                        } else {
                            phi_1360_ = u32();
                        }
                        let _e915 = phi_1360_;
                        continue;
                        continuing {
                            phi_1356_ = type_9(select(_e840.member, (_e840.member + 1u), _e845), select(_e840.member_1, _e840.member_1, _e845));
                            phi_1359_ = _e915;
                            break if !(_e858);
                        }
                    }
                    workgroupBarrier();
                    let _e918 = n_hits[0u];
                    let _e919 = (_e918 - _e829);
                    let _e921 = select(_e919, 512u, (512u < _e919));
                    if (_e44 == 0u) {
                        atomicStore((&counters[5u]), _e921);
                    }
                    workgroupBarrier();
                    if (_e44 == 0u) {
                        let _e926 = atomicLoad((&counters[5u]));
                        if (_e926 > 0u) {
                            let _e930 = params.member.member.member_1;
                            if ((_e930 & 1024u) != 0u) {
                                let _e940 = atomicAdd((&output.member[0u]), _e926);
                                let _e941 = (_e940 + _e926);
                                let _e943 = select(_e941, 4294967295u, (_e941 < _e940));
                                let _e946 = params.member.member_1.member_3;
                                if (_e943 > _e946) {
                                    let _e949 = atomicMax((&output.member[2u]), _e943);
                                }
                                phi_1533_ = _e940;
                            } else {
                                let _e934 = atomicAdd((&output.member[0u]), _e926);
                                if ((_e934 + _e926) < _e934) {
                                    let _e938 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1533_ = _e934;
                            }
                            let _e951 = phi_1533_;
                            atomicStore((&counters[6u]), _e951);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e955 = atomicLoad((&counters[6u]));
                    phi_1540_ = type_9(0u, 4u);
                    loop {
                        let _e957 = phi_1540_;
                        let _e960 = (_e957.member < _e957.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e960)) != 0i) {
                            let _e975 = (_e44 + (select(type_9().member_1, _e957.member, _e960) * 128u));
                            if (_e975 >= _e921) {
                                phi_1613_ = false;
                            } else {
                                let _e978 = hits[_e975];
                                let _e981 = ((_e978 >> bitcast<u32>(10i)) & 3u);
                                let _e989 = names[((_e981 * 32u) + (_e978 & 31u))];
                                let _e992 = firsts[(2u * _e981)];
                                let _e997 = firsts[((2u * _e981) + 1u)];
                                let _e1001 = params.member.member_1.member_3;
                                let _e1002 = (_e955 + _e975);
                                if (_e1002 < _e1001) {
                                    let _e1004 = (2u * _e1002);
                                    atomicStore((&output.member[(4u + _e1004)]), (_e992 + ((_e978 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e1004 + 5u)]), (_e997 + _e989));
                                }
                                phi_1613_ = true;
                            }
                            let _e1010 = phi_1613_;
                            phi_1614_ = _e1010;
                        } else {
                            phi_1614_ = false;
                        }
                        let _e1012 = phi_1614_;
                        continue;
                        continuing {
                            phi_1540_ = type_9(select(_e957.member, (_e957.member + 1u), _e960), select(_e957.member_1, _e957.member_1, _e960));
                            break if !(_e1012);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1294_ = type_9(select(_e805.member, (_e805.member + 1u), _e808), select(_e805.member_1, _e805.member_1, _e808));
                    break if !(_e821);
                }
            }
        }
        continue;
        continuing {
            phi_256_ = type_9(select(_e111.member, (_e111.member + 1u), _e114), select(_e111.member_1, _e111.member_1, _e114));
            break if !(_e127);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
