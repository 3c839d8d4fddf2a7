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
    var phi_206_: u32;
    var phi_254_: u32;
    var phi_257_: type_9;
    var phi_329_: u32;
    var phi_432_: type_9;
    var phi_435_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_528_: type_9;
    var phi_531_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_787_: bool;
    var phi_825_: type_24;
    var phi_860_: type_9;
    var phi_863_: u32;
    var phi_864_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1105_: type_9;
    var phi_1108_: u32;
    var phi_1109_: u32;
    var phi_1173_: u32;
    var phi_1174_: u32;
    var phi_1178_: type_9;
    var phi_1181_: u32;
    var phi_1182_: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var phi_1273_: type_9;
    var phi_1302_: type_9;
    var phi_1305_: type_9;
    var phi_1345_: type_9;
    var phi_1348_: type_9;
    var phi_1405_: type_9;
    var phi_1406_: bool;
    var phi_1346_: type_9;
    var phi_1407_: bool;
    var phi_1472_: u32;
    var phi_1479_: type_9;
    var phi_1548_: bool;
    var phi_1549_: bool;
    var phi_1306_: type_9;
    var local_14: u32;
    var local_15: type_9;
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
        phi_206_ = select(_e80, (_e80 + 1u), ((_e75 % _e78) > 0u));
    } else {
        phi_206_ = 0u;
    }
    let _e87 = phi_206_;
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
        phi_254_ = select(_e101, (_e101 + 1u), ((_e99 % _e57) > 0u));
    } else {
        phi_254_ = 0u;
    }
    let _e108 = phi_254_;
    phi_257_ = type_9(0u, _e108);
    loop {
        let _e111 = phi_257_;
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
                phi_329_ = select(_e145, (_e145 + 1u), ((_e140 % _e143) > 0u));
            } else {
                phi_329_ = 0u;
            }
            let _e152 = phi_329_;
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
            phi_432_ = type_9(0u, _e194);
            phi_435_ = 1u;
            loop {
                let _e208 = phi_432_;
                let _e210 = phi_435_;
                local_1 = _e210;
                local_2 = _e210;
                local_3 = _e210;
                local_4 = _e210;
                let _e213 = (_e208.member < _e208.member_1);
                let _e224 = (bitcast<i32>(select(0u, 1u, _e213)) != 0i);
                continue;
                continuing {
                    phi_432_ = type_9(select(_e208.member, (_e208.member + 1u), _e213), select(_e208.member_1, _e208.member_1, _e213));
                    phi_435_ = select(u32(), (_e210 * 32u), _e224);
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
            phi_528_ = type_9(0u, _e194);
            phi_531_ = 1u;
            loop {
                let _e266 = phi_528_;
                let _e268 = phi_531_;
                local_5 = _e268;
                local_6 = _e268;
                local_7 = _e268;
                local_8 = _e268;
                let _e271 = (_e266.member < _e266.member_1);
                let _e282 = (bitcast<i32>(select(0u, 1u, _e271)) != 0i);
                continue;
                continuing {
                    phi_528_ = type_9(select(_e266.member, (_e266.member + 1u), _e271), select(_e266.member_1, _e266.member_1, _e271));
                    phi_531_ = select(u32(), (_e268 * 32u), _e282);
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
                phi_787_ = ((((((_e380.member.x <= _e356.member_1.y) && (_e356.member.x <= _e380.member_1.y)) && (_e380.member.y <= _e356.member_2.x)) && (_e356.member.y <= _e380.member_2.x)) && (_e380.member_1.x <= _e356.member_2.y)) && (_e356.member_1.x <= _e380.member_2.y));
            } else {
                phi_787_ = false;
            }
            let _e432 = phi_787_;
            if _e158 {
                if ((((((_e407.member.x <= _e335.member_1.y) && (_e335.member.x <= _e407.member_1.y)) && (_e407.member.y <= _e335.member_2.x)) && (_e335.member.y <= _e407.member_2.x)) && (_e407.member_1.x <= _e335.member_2.y)) && (_e335.member_1.x <= _e407.member_2.y)) {
                    let _e446 = atomicAdd((&counters[_e325]), 1u);
                    let _e447 = ((_e325 * 32u) + _e446);
                    columns[_e447] = type_24(array<f32, 3>(_e407.member.x, _e407.member.y, _e407.member_1.x), array<f32, 3>(_e407.member_1.y, _e407.member_2.x, _e407.member_2.y));
                    names[_e447] = _e326;
                }
            }
            if _e432 {
                phi_825_ = type_24(array<f32, 3>(_e380.member.x, _e380.member.y, _e380.member_1.x), array<f32, 3>(_e380.member_1.y, _e380.member_2.x, _e380.member_2.y));
            } else {
                phi_825_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e454 = phi_825_;
            workgroupBarrier();
            let _e457 = params.member.member_2.member_1;
            let _e460 = select(false, (_e171 == _e174), (_e457 == 1u));
            let _e461 = (_e44 / 32u);
            let _e462 = (_e44 % 32u);
            let _e463 = (_e461 * 32u);
            let _e465 = atomicLoad((&counters[_e461]));
            let _e466 = (_e465 / 4u);
            phi_860_ = type_9(0u, select(_e466, (_e466 + 1u), ((_e465 % 4u) > 0u)));
            phi_863_ = 0u;
            loop {
                let _e473 = phi_860_;
                let _e475 = phi_863_;
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
                    phi_864_ = (_e475 | ((((select(0u, 1u, ((((((_e454.member[0] <= _e495.member_1[0]) && (_e495.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e495.member_1[1])) && (_e495.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e495.member_1[2])) && (_e495.member[2] <= _e454.member_1[2]))) << bitcast<u32>((_e492 & 31u))) | (select(0u, 1u, ((((((_e454.member[0] <= _e534.member_1[0]) && (_e534.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e534.member_1[1])) && (_e534.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e534.member_1[2])) && (_e534.member[2] <= _e454.member_1[2]))) << bitcast<u32>(((_e492 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e454.member[0] <= _e575.member_1[0]) && (_e575.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e575.member_1[1])) && (_e575.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e575.member_1[2])) && (_e575.member[2] <= _e454.member_1[2]))) << bitcast<u32>(((_e492 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e454.member[0] <= _e616.member_1[0]) && (_e616.member[0] <= _e454.member_1[0])) && (_e454.member[1] <= _e616.member_1[1])) && (_e616.member[1] <= _e454.member_1[1])) && (_e454.member[2] <= _e616.member_1[2])) && (_e616.member[2] <= _e454.member_1[2]))) << bitcast<u32>(((_e492 + 3u) & 31u)))));
                } else {
                    phi_864_ = u32();
                }
                let _e656 = phi_864_;
                continue;
                continuing {
                    phi_860_ = type_9(select(_e473.member, (_e473.member + 1u), _e478), select(_e473.member_1, _e473.member_1, _e478));
                    phi_863_ = _e656;
                    break if !(_e491);
                }
            }
            let _e664 = local_9;
            let _e667 = local_10;
            let _e668 = select(_e667, (_e664 & ((1u << bitcast<u32>((_e465 & 31u))) - 1u)), (_e465 < 32u));
            let _e671 = params.member.member.member_1;
            if ((_e671 & 256u) != 0u) {
                if select(!((_e454.member[0] <= _e454.member_1[0])), true, ((bitcast<u32>(_e454.member_1[0]) & 1u) == 1u)) {
                    phi_1105_ = type_9(0u, _e465);
                    phi_1108_ = _e668;
                    loop {
                        let _e688 = phi_1105_;
                        let _e690 = phi_1108_;
                        local_14 = _e690;
                        let _e693 = (_e688.member < _e688.member_1);
                        let _e704 = select(type_9().member_1, _e688.member, _e693);
                        let _e706 = (bitcast<i32>(select(0u, 1u, _e693)) != 0i);
                        if _e706 {
                            let _e709 = columns[(_e463 + _e704)];
                            phi_1109_ = select(_e690, (_e690 & ~((1u << bitcast<u32>((_e704 & 31u))))), select(!((_e709.member[0] <= _e709.member_1[0])), true, ((bitcast<u32>(_e709.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_1109_ = u32();
                        }
                        let _e727 = phi_1109_;
                        continue;
                        continuing {
                            phi_1105_ = type_9(select(_e688.member, (_e688.member + 1u), _e693), select(_e688.member_1, _e688.member_1, _e693));
                            phi_1108_ = _e727;
                            break if !(_e706);
                        }
                    }
                    let _e1016 = local_14;
                    phi_1173_ = _e1016;
                } else {
                    phi_1173_ = _e668;
                }
                let _e730 = phi_1173_;
                phi_1174_ = _e730;
            } else {
                phi_1174_ = _e668;
            }
            let _e732 = phi_1174_;
            phi_1178_ = type_9(0u, _e465);
            phi_1181_ = _e732;
            loop {
                let _e735 = phi_1178_;
                let _e737 = phi_1181_;
                local_11 = _e737;
                local_12 = _e737;
                local_13 = _e737;
                let _e740 = (_e735.member < _e735.member_1);
                let _e751 = select(type_9().member_1, _e735.member, _e740);
                let _e753 = (bitcast<i32>(select(0u, 1u, _e740)) != 0i);
                if _e753 {
                    let _e756 = names[(_e463 + _e751)];
                    let _e759 = ranges[(_e463 + _e756)];
                    let _e769 = (_e462 < _e756);
                    phi_1182_ = select(_e737, (_e737 & ~((1u << bitcast<u32>((_e751 & 31u))))), select(true, select(true, false, select(false, ((_e759 >> bitcast<u32>(16i)) <= (_e259 & 65535u)), ((_e259 >> bitcast<u32>(16i)) <= (_e759 & 65535u)))), select(select(bool(), select(select(false, true, (_e462 == _e756)), bool(), _e769), _e460), true, select(true, _e769, _e460))));
                } else {
                    phi_1182_ = u32();
                }
                let _e785 = phi_1182_;
                continue;
                continuing {
                    phi_1178_ = type_9(select(_e735.member, (_e735.member + 1u), _e740), select(_e735.member_1, _e735.member_1, _e740));
                    phi_1181_ = _e785;
                    break if !(_e753);
                }
            }
            let _e788 = local_11;
            let _e791 = local_12;
            let _e792 = countOneBits(_e791);
            if (_e792 > 0u) {
                let _e795 = atomicAdd((&counters[4u]), _e792);
                let _e797 = local_13;
                phi_1273_ = type_9(_e797, _e795);
            } else {
                phi_1273_ = type_9(_e788, 0u);
            }
            let _e800 = phi_1273_;
            workgroupBarrier();
            if (_e44 == 0u) {
                let _e803 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e803;
            }
            let _e806 = workgroupUniformLoad((&n_hits[0u]));
            let _e807 = (_e806 / 512u);
            phi_1302_ = type_9(0u, select(_e807, (_e807 + 1u), ((_e806 % 512u) > 0u)));
            phi_1305_ = _e800;
            loop {
                let _e814 = phi_1302_;
                let _e816 = phi_1305_;
                let _e819 = (_e814.member < _e814.member_1);
                let _e832 = (bitcast<i32>(select(0u, 1u, _e819)) != 0i);
                if _e832 {
                    let _e833 = (_e44 / 32u);
                    let _e835 = (select(type_9().member_1, _e814.member, _e819) * 512u);
                    phi_1345_ = _e816;
                    phi_1348_ = type_9(0u, countOneBits(_e816.member));
                    loop {
                        let _e840 = phi_1345_;
                        let _e842 = phi_1348_;
                        local_15 = _e840;
                        let _e845 = (_e842.member < _e842.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e845)) != 0i) {
                            let _e858 = (_e840.member_1 - _e835);
                            if (_e858 >= 512u) {
                                phi_1405_ = type_9();
                                phi_1406_ = false;
                            } else {
                                let _e867 = names[((_e833 * 32u) + select(firstTrailingBit(_e840.member), 32u, (_e840.member == 0u)))];
                                hits[_e858] = (((_e833 << bitcast<u32>(10i)) | ((_e44 % 32u) << bitcast<u32>(5i))) | _e867);
                                phi_1405_ = type_9((_e840.member & (_e840.member - 1u)), (_e840.member_1 + 1u));
                                phi_1406_ = true;
                            }
                            let _e883 = phi_1405_;
                            let _e885 = phi_1406_;
                            phi_1346_ = _e883;
                            phi_1407_ = _e885;
                        } else {
                            phi_1346_ = type_9();
                            phi_1407_ = false;
                        }
                        let _e887 = phi_1346_;
                        let _e889 = phi_1407_;
                        continue;
                        continuing {
                            phi_1345_ = _e887;
                            phi_1348_ = type_9(select(_e842.member, (_e842.member + 1u), _e845), select(_e842.member_1, _e842.member_1, _e845));
                            break if !(_e889);
                        }
                    }
                    workgroupBarrier();
                    let _e892 = n_hits[0u];
                    let _e893 = (_e892 - _e835);
                    let _e895 = select(_e893, 512u, (512u < _e893));
                    if (_e44 == 0u) {
                        atomicStore((&counters[5u]), _e895);
                    }
                    workgroupBarrier();
                    if (_e44 == 0u) {
                        let _e900 = atomicLoad((&counters[5u]));
                        if (_e900 > 0u) {
                            let _e904 = params.member.member.member_1;
                            if ((_e904 & 1024u) != 0u) {
                                let _e914 = atomicAdd((&output.member[0u]), _e900);
                                let _e915 = (_e914 + _e900);
                                let _e917 = select(_e915, 4294967295u, (_e915 < _e914));
                                let _e920 = params.member.member_1.member_3;
                                if (_e917 > _e920) {
                                    let _e923 = atomicMax((&output.member[2u]), _e917);
                                }
                                phi_1472_ = _e914;
                            } else {
                                let _e908 = atomicAdd((&output.member[0u]), _e900);
                                if ((_e908 + _e900) < _e908) {
                                    let _e912 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1472_ = _e908;
                            }
                            let _e925 = phi_1472_;
                            atomicStore((&counters[6u]), _e925);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e929 = atomicLoad((&counters[6u]));
                    phi_1479_ = type_9(0u, 4u);
                    loop {
                        let _e931 = phi_1479_;
                        let _e934 = (_e931.member < _e931.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e934)) != 0i) {
                            let _e949 = (_e44 + (select(type_9().member_1, _e931.member, _e934) * 128u));
                            if (_e949 >= _e895) {
                                phi_1548_ = false;
                            } else {
                                let _e952 = hits[_e949];
                                let _e955 = ((_e952 >> bitcast<u32>(10i)) & 3u);
                                let _e962 = firsts[(2u * _e955)];
                                let _e967 = firsts[((2u * _e955) + 1u)];
                                let _e971 = params.member.member_1.member_3;
                                let _e972 = (_e929 + _e949);
                                if (_e972 < _e971) {
                                    let _e974 = (2u * _e972);
                                    atomicStore((&output.member[(4u + _e974)]), (_e962 + ((_e952 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e974 + 5u)]), (_e967 + (_e952 & 31u)));
                                }
                                phi_1548_ = true;
                            }
                            let _e980 = phi_1548_;
                            phi_1549_ = _e980;
                        } else {
                            phi_1549_ = false;
                        }
                        let _e982 = phi_1549_;
                        continue;
                        continuing {
                            phi_1479_ = type_9(select(_e931.member, (_e931.member + 1u), _e934), select(_e931.member_1, _e931.member_1, _e934));
                            break if !(_e982);
                        }
                    }
                    workgroupBarrier();
                    let _e1039 = local_15;
                    phi_1306_ = _e1039;
                } else {
                    phi_1306_ = type_9();
                }
                let _e985 = phi_1306_;
                continue;
                continuing {
                    phi_1302_ = type_9(select(_e814.member, (_e814.member + 1u), _e819), select(_e814.member_1, _e814.member_1, _e819));
                    phi_1305_ = _e985;
                    break if !(_e832);
                }
            }
        }
        continue;
        continuing {
            phi_257_ = type_9(select(_e111.member, (_e111.member + 1u), _e114), select(_e111.member_1, _e111.member_1, _e114));
            break if !(_e127);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
