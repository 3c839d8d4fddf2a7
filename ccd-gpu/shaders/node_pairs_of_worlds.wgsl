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
    var phi_164_: u32;
    var phi_191_: u32;
    var phi_223_: u32;
    var phi_350_: type_9;
    var phi_353_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_446_: type_9;
    var phi_449_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_705_: bool;
    var phi_743_: type_24;
    var phi_778_: type_9;
    var phi_781_: u32;
    var phi_782_: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1023_: type_9;
    var phi_1026_: u32;
    var phi_1027_: u32;
    var phi_1091_: u32;
    var phi_1092_: u32;
    var phi_1096_: type_9;
    var phi_1099_: u32;
    var phi_1100_: u32;
    var local_11: u32;
    var phi_1213_: type_9;
    var phi_1275_: type_9;
    var phi_1278_: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var phi_1279_: u32;
    var phi_1452_: u32;
    var phi_1459_: type_9;
    var phi_1532_: bool;
    var phi_1533_: bool;
    var phi_224_: u32;
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
    let _e60 = params.member.member_1.member_2;
    let _e62 = input.member[0u];
    let _e64 = select(_e62, _e60, (_e60 < _e62));
    let _e67 = params.member.member_1.member_1;
    if (_e64 > _e67) {
        let _e71 = params.member.member_1.member_1;
        phi_164_ = (_e64 - _e71);
    } else {
        phi_164_ = 0u;
    }
    let _e74 = phi_164_;
    let _e77 = params.member.member_2.member_3;
    if (_e77 == 1u) {
        phi_191_ = _e74;
    } else {
        let _e81 = params.member.member_2.member_3;
        if (_e81 == 0u) {
            return;
        }
        let _e83 = (_e74 / _e81);
        if (_e81 == 0u) {
            return;
        }
        phi_191_ = select(_e83, (_e83 + 1u), ((_e74 % _e81) > 0u));
    }
    let _e90 = phi_191_;
    let _e93 = params.member.member_2.member_4;
    let _e95 = select(_e90, _e93, (_e93 < _e90));
    let _e97 = (_e44 / 32u);
    let _e98 = (_e44 % 32u);
    phi_223_ = ((_e42.y * _e43.x) + _e42.x);
    loop {
        let _e100 = phi_223_;
        let _e101 = (_e95 / 4u);
        let _e106 = (_e100 < select(_e101, (_e101 + 1u), ((_e95 % 4u) > 0u)));
        if _e106 {
            let _e109 = ((_e100 * 4u) + (_e44 / 32u));
            let _e110 = (_e109 < _e95);
            let _e113 = params.member.member_1.member_1;
            let _e116 = params.member.member_2.member_3;
            let _e120 = (2u * (_e113 + select(0u, (_e109 * _e116), _e110)));
            let _e123 = input.member[(4u + _e120)];
            let _e126 = input.member[(_e120 + 5u)];
            if (_e44 <= 5u) {
                atomicStore((&counters[_e44]), 0u);
            }
            workgroupBarrier();
            if (_e98 == 0u) {
                firsts[(2u * _e97)] = (_e123 * 32u);
                firsts[((2u * _e97) + 1u)] = (_e126 * 32u);
            }
            let _e140 = params.member.member_2.member_1;
            let _e141 = (_e140 == 0u);
            let _e142 = select(1u, 0u, _e141);
            let _e143 = select(1u, 2u, _e141);
            let _e146 = params.member.member_2.member_2;
            let _e147 = (_e146 - 1u);
            let _e150 = params.member.member.member;
            local = array<u32, 3>(_e150[0], _e150[1], _e150[2]);
            let _e156 = ((_e123 * 32u) + _e98);
            let _e158 = local[_e142];
            phi_350_ = type_9(0u, _e147);
            phi_353_ = 1u;
            loop {
                let _e161 = phi_350_;
                let _e163 = phi_353_;
                local_1 = _e163;
                local_2 = _e163;
                local_3 = _e163;
                local_4 = _e163;
                let _e166 = (_e161.member < _e161.member_1);
                let _e177 = (bitcast<i32>(select(0u, 1u, _e166)) != 0i);
                continue;
                continuing {
                    phi_350_ = type_9(select(_e161.member, (_e161.member + 1u), _e166), select(_e161.member_1, _e161.member_1, _e166));
                    phi_353_ = select(u32(), (_e163 * 32u), _e177);
                    break if !(_e177);
                }
            }
            let _e183 = local_1;
            if (_e183 == 0u) {
                return;
            }
            let _e186 = local_2;
            let _e187 = ((_e158 - 1u) / _e186);
            let _e191 = local_3;
            let _e192 = (select(_e156, _e187, (_e187 < _e156)) * _e191);
            let _e194 = local_4;
            let _e196 = (_e192 + (_e194 - 1u));
            let _e197 = (_e158 - 1u);
            let _e203 = params.member.member_2.member[0u][_e142];
            let _e206 = worlds.member[(_e203 + _e192)];
            let _e211 = worlds.member[(_e203 + select(_e196, _e197, (_e197 < _e196)))];
            let _e212 = ((_e206 << bitcast<u32>(16i)) | _e211);
            let _e214 = ((_e126 * 32u) + _e98);
            let _e216 = local[_e143];
            phi_446_ = type_9(0u, _e147);
            phi_449_ = 1u;
            loop {
                let _e219 = phi_446_;
                let _e221 = phi_449_;
                local_5 = _e221;
                local_6 = _e221;
                local_7 = _e221;
                local_8 = _e221;
                let _e224 = (_e219.member < _e219.member_1);
                let _e235 = (bitcast<i32>(select(0u, 1u, _e224)) != 0i);
                continue;
                continuing {
                    phi_446_ = type_9(select(_e219.member, (_e219.member + 1u), _e224), select(_e219.member_1, _e219.member_1, _e224));
                    phi_449_ = select(u32(), (_e221 * 32u), _e235);
                    break if !(_e235);
                }
            }
            let _e241 = local_5;
            if (_e241 == 0u) {
                return;
            }
            let _e244 = local_6;
            let _e245 = ((_e216 - 1u) / _e244);
            let _e249 = local_7;
            let _e250 = (select(_e214, _e245, (_e245 < _e214)) * _e249);
            let _e252 = local_8;
            let _e254 = (_e250 + (_e252 - 1u));
            let _e255 = (_e216 - 1u);
            let _e261 = params.member.member_2.member[0u][_e143];
            let _e264 = worlds.member[(_e261 + _e250)];
            let _e269 = worlds.member[(_e261 + select(_e254, _e255, (_e255 < _e254)))];
            ranges[_e44] = ((_e264 << bitcast<u32>(16i)) | _e269);
            let _e274 = params.member.member_2.member_1;
            let _e275 = (_e274 == 0u);
            let _e276 = select(1u, 0u, _e275);
            let _e277 = select(1u, 2u, _e275);
            let _e278 = (_e44 / 32u);
            let _e279 = (_e44 % 32u);
            let _e281 = params.member.member_2.member_2;
            let _e285 = params.member.member_2.member[_e281][_e276];
            let _e288 = nodes.member[(_e285 + _e123)];
            let _e302 = params.member.member_2.member_2;
            let _e306 = params.member.member_2.member[_e302][_e277];
            let _e309 = nodes.member[(_e306 + _e126)];
            let _e323 = params.member.member_2.member_2;
            let _e330 = params.member.member_2.member[(_e323 - 1u)][_e276];
            let _e333 = nodes.member[(_e330 + ((_e123 * 32u) + _e279))];
            let _e350 = params.member.member_2.member_2;
            let _e357 = params.member.member_2.member[(_e350 - 1u)][_e277];
            let _e360 = nodes.member[(_e357 + ((_e126 * 32u) + _e279))];
            if _e110 {
                phi_705_ = ((((((_e333.member.x <= _e309.member_1.y) && (_e309.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e309.member_2.x)) && (_e309.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e309.member_2.y)) && (_e309.member_1.x <= _e333.member_2.y));
            } else {
                phi_705_ = false;
            }
            let _e385 = phi_705_;
            if _e110 {
                if ((((((_e360.member.x <= _e288.member_1.y) && (_e288.member.x <= _e360.member_1.y)) && (_e360.member.y <= _e288.member_2.x)) && (_e288.member.y <= _e360.member_2.x)) && (_e360.member_1.x <= _e288.member_2.y)) && (_e288.member_1.x <= _e360.member_2.y)) {
                    let _e399 = atomicAdd((&counters[_e278]), 1u);
                    let _e400 = ((_e278 * 32u) + _e399);
                    columns[_e400] = type_24(array<f32, 3>(_e360.member.x, _e360.member.y, _e360.member_1.x), array<f32, 3>(_e360.member_1.y, _e360.member_2.x, _e360.member_2.y));
                    names[_e400] = _e279;
                }
            }
            if _e385 {
                phi_743_ = type_24(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
            } else {
                phi_743_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e407 = phi_743_;
            workgroupBarrier();
            let _e410 = params.member.member_2.member_1;
            let _e413 = select(false, (_e123 == _e126), (_e410 == 1u));
            let _e414 = (_e44 / 32u);
            let _e415 = (_e44 % 32u);
            let _e416 = (_e414 * 32u);
            let _e418 = atomicLoad((&counters[_e414]));
            let _e419 = (_e418 / 4u);
            phi_778_ = type_9(0u, select(_e419, (_e419 + 1u), ((_e418 % 4u) > 0u)));
            phi_781_ = 0u;
            loop {
                let _e426 = phi_778_;
                let _e428 = phi_781_;
                local_9 = _e428;
                local_10 = _e428;
                let _e431 = (_e426.member < _e426.member_1);
                let _e444 = (bitcast<i32>(select(0u, 1u, _e431)) != 0i);
                if _e444 {
                    let _e445 = (4u * select(type_9().member_1, _e426.member, _e431));
                    let _e448 = columns[(_e416 + _e445)];
                    let _e487 = columns[((_e416 + _e445) + 1u)];
                    let _e528 = columns[((_e416 + _e445) + 2u)];
                    let _e569 = columns[((_e416 + _e445) + 3u)];
                    phi_782_ = (_e428 | ((((select(0u, 1u, ((((((_e407.member[0] <= _e448.member_1[0]) && (_e448.member[0] <= _e407.member_1[0])) && (_e407.member[1] <= _e448.member_1[1])) && (_e448.member[1] <= _e407.member_1[1])) && (_e407.member[2] <= _e448.member_1[2])) && (_e448.member[2] <= _e407.member_1[2]))) << bitcast<u32>((_e445 & 31u))) | (select(0u, 1u, ((((((_e407.member[0] <= _e487.member_1[0]) && (_e487.member[0] <= _e407.member_1[0])) && (_e407.member[1] <= _e487.member_1[1])) && (_e487.member[1] <= _e407.member_1[1])) && (_e407.member[2] <= _e487.member_1[2])) && (_e487.member[2] <= _e407.member_1[2]))) << bitcast<u32>(((_e445 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e407.member[0] <= _e528.member_1[0]) && (_e528.member[0] <= _e407.member_1[0])) && (_e407.member[1] <= _e528.member_1[1])) && (_e528.member[1] <= _e407.member_1[1])) && (_e407.member[2] <= _e528.member_1[2])) && (_e528.member[2] <= _e407.member_1[2]))) << bitcast<u32>(((_e445 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e407.member[0] <= _e569.member_1[0]) && (_e569.member[0] <= _e407.member_1[0])) && (_e407.member[1] <= _e569.member_1[1])) && (_e569.member[1] <= _e407.member_1[1])) && (_e407.member[2] <= _e569.member_1[2])) && (_e569.member[2] <= _e407.member_1[2]))) << bitcast<u32>(((_e445 + 3u) & 31u)))));
                } else {
                    phi_782_ = u32();
                }
                let _e609 = phi_782_;
                continue;
                continuing {
                    phi_778_ = type_9(select(_e426.member, (_e426.member + 1u), _e431), select(_e426.member_1, _e426.member_1, _e431));
                    phi_781_ = _e609;
                    break if !(_e444);
                }
            }
            let _e617 = local_9;
            let _e620 = local_10;
            let _e621 = select(_e620, (_e617 & ((1u << bitcast<u32>((_e418 & 31u))) - 1u)), (_e418 < 32u));
            let _e624 = params.member.member.member_1;
            if ((_e624 & 256u) != 0u) {
                if select(!((_e407.member[0] <= _e407.member_1[0])), true, ((bitcast<u32>(_e407.member_1[0]) & 1u) == 1u)) {
                    phi_1023_ = type_9(0u, _e418);
                    phi_1026_ = _e621;
                    loop {
                        let _e641 = phi_1023_;
                        let _e643 = phi_1026_;
                        local_16 = _e643;
                        let _e646 = (_e641.member < _e641.member_1);
                        let _e657 = select(type_9().member_1, _e641.member, _e646);
                        let _e659 = (bitcast<i32>(select(0u, 1u, _e646)) != 0i);
                        if _e659 {
                            let _e662 = columns[(_e416 + _e657)];
                            phi_1027_ = select(_e643, (_e643 & ~((1u << bitcast<u32>((_e657 & 31u))))), select(!((_e662.member[0] <= _e662.member_1[0])), true, ((bitcast<u32>(_e662.member_1[0]) & 1u) == 1u)));
                        } else {
                            phi_1027_ = u32();
                        }
                        let _e680 = phi_1027_;
                        continue;
                        continuing {
                            phi_1023_ = type_9(select(_e641.member, (_e641.member + 1u), _e646), select(_e641.member_1, _e641.member_1, _e646));
                            phi_1026_ = _e680;
                            break if !(_e659);
                        }
                    }
                    let _e998 = local_16;
                    phi_1091_ = _e998;
                } else {
                    phi_1091_ = _e621;
                }
                let _e683 = phi_1091_;
                phi_1092_ = _e683;
            } else {
                phi_1092_ = _e621;
            }
            let _e685 = phi_1092_;
            phi_1096_ = type_9(0u, _e418);
            phi_1099_ = _e685;
            loop {
                let _e688 = phi_1096_;
                let _e690 = phi_1099_;
                local_11 = _e690;
                local_12 = _e690;
                local_13 = _e690;
                local_14 = _e690;
                local_15 = _e690;
                let _e693 = (_e688.member < _e688.member_1);
                let _e704 = select(type_9().member_1, _e688.member, _e693);
                let _e706 = (bitcast<i32>(select(0u, 1u, _e693)) != 0i);
                if _e706 {
                    let _e709 = names[(_e416 + _e704)];
                    let _e712 = ranges[(_e416 + _e709)];
                    let _e722 = (_e415 < _e709);
                    phi_1100_ = select(_e690, (_e690 & ~((1u << bitcast<u32>((_e704 & 31u))))), select(true, select(true, false, select(false, ((_e712 >> bitcast<u32>(16i)) <= (_e212 & 65535u)), ((_e212 >> bitcast<u32>(16i)) <= (_e712 & 65535u)))), select(select(bool(), select(select(false, true, (_e415 == _e709)), bool(), _e722), _e413), true, select(true, _e722, _e413))));
                } else {
                    phi_1100_ = u32();
                }
                let _e738 = phi_1100_;
                continue;
                continuing {
                    phi_1096_ = type_9(select(_e688.member, (_e688.member + 1u), _e693), select(_e688.member_1, _e688.member_1, _e693));
                    phi_1099_ = _e738;
                    break if !(_e706);
                }
            }
            let _e741 = local_11;
            let _e744 = atomicAdd((&counters[4u]), countOneBits(_e741));
            workgroupBarrier();
            if (_e44 == 0u) {
                let _e747 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e747;
            }
            let _e750 = workgroupUniformLoad((&n_hits[0u]));
            let _e751 = (_e750 / 512u);
            phi_1213_ = type_9(0u, select(_e751, (_e751 + 1u), ((_e750 % 512u) > 0u)));
            loop {
                let _e758 = phi_1213_;
                let _e761 = (_e758.member < _e758.member_1);
                let _e774 = (bitcast<i32>(select(0u, 1u, _e761)) != 0i);
                if _e774 {
                    let _e775 = (_e44 / 32u);
                    let _e781 = ((_e775 << bitcast<u32>(10i)) | ((_e44 % 32u) << bitcast<u32>(5i)));
                    let _e782 = (select(type_9().member_1, _e758.member, _e761) * 512u);
                    let _e785 = atomicLoad((&counters[_e775]));
                    let _e786 = (_e785 / 4u);
                    phi_1275_ = type_9(0u, select(_e786, (_e786 + 1u), ((_e785 % 4u) > 0u)));
                    phi_1278_ = (_e744 - _e782);
                    loop {
                        let _e793 = phi_1275_;
                        let _e795 = phi_1278_;
                        let _e798 = (_e793.member < _e793.member_1);
                        let _e811 = (bitcast<i32>(select(0u, 1u, _e798)) != 0i);
                        if _e811 {
                            let _e812 = (4u * select(type_9().member_1, _e793.member, _e798));
                            let _e816 = local_12;
                            let _e820 = (((_e816 >> bitcast<u32>((_e812 & 31u))) & 1u) == 1u);
                            if _e820 {
                                if (_e795 < 512u) {
                                    hits[_e795] = (_e781 + _e812);
                                }
                            }
                            let _e824 = select(_e795, (_e795 + 1u), _e820);
                            let _e830 = local_13;
                            let _e834 = (((_e830 >> bitcast<u32>(((_e812 + 1u) & 31u))) & 1u) == 1u);
                            if _e834 {
                                if (_e824 < 512u) {
                                    hits[_e824] = ((_e781 + _e812) + 1u);
                                }
                            }
                            let _e838 = select(_e824, (_e824 + 1u), _e834);
                            let _e844 = local_14;
                            let _e848 = (((_e844 >> bitcast<u32>(((_e812 + 2u) & 31u))) & 1u) == 1u);
                            if _e848 {
                                if (_e838 < 512u) {
                                    hits[_e838] = ((_e781 + _e812) + 2u);
                                }
                            }
                            let _e852 = select(_e838, (_e838 + 1u), _e848);
                            let _e858 = local_15;
                            let _e862 = (((_e858 >> bitcast<u32>(((_e812 + 3u) & 31u))) & 1u) == 1u);
                            if _e862 {
                                if (_e852 < 512u) {
                                    hits[_e852] = ((_e781 + _e812) + 3u);
                                }
                            }
                            phi_1279_ = select(_e852, (_e852 + 1u), _e862);
                        } else {
                            phi_1279_ = u32();
                        }
                        let _e868 = phi_1279_;
                        continue;
                        continuing {
                            phi_1275_ = type_9(select(_e793.member, (_e793.member + 1u), _e798), select(_e793.member_1, _e793.member_1, _e798));
                            phi_1278_ = _e868;
                            break if !(_e811);
                        }
                    }
                    workgroupBarrier();
                    let _e871 = n_hits[0u];
                    let _e872 = (_e871 - _e782);
                    let _e874 = select(_e872, 512u, (512u < _e872));
                    if (_e44 == 0u) {
                        atomicStore((&counters[5u]), _e874);
                    }
                    workgroupBarrier();
                    if (_e44 == 0u) {
                        let _e879 = atomicLoad((&counters[5u]));
                        if (_e879 > 0u) {
                            let _e883 = params.member.member.member_1;
                            if ((_e883 & 1024u) != 0u) {
                                let _e893 = atomicAdd((&output.member[0u]), _e879);
                                let _e894 = (_e893 + _e879);
                                let _e896 = select(_e894, 4294967295u, (_e894 < _e893));
                                let _e899 = params.member.member_1.member_3;
                                if (_e896 > _e899) {
                                    let _e902 = atomicMax((&output.member[2u]), _e896);
                                }
                                phi_1452_ = _e893;
                            } else {
                                let _e887 = atomicAdd((&output.member[0u]), _e879);
                                if ((_e887 + _e879) < _e887) {
                                    let _e891 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1452_ = _e887;
                            }
                            let _e904 = phi_1452_;
                            atomicStore((&counters[6u]), _e904);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e908 = atomicLoad((&counters[6u]));
                    phi_1459_ = type_9(0u, 4u);
                    loop {
                        let _e910 = phi_1459_;
                        let _e913 = (_e910.member < _e910.member_1);
                        if (bitcast<i32>(select(0u, 1u, _e913)) != 0i) {
                            let _e928 = (_e44 + (select(type_9().member_1, _e910.member, _e913) * 128u));
                            if (_e928 >= _e874) {
                                phi_1532_ = false;
                            } else {
                                let _e931 = hits[_e928];
                                let _e934 = ((_e931 >> bitcast<u32>(10i)) & 3u);
                                let _e942 = names[((_e934 * 32u) + (_e931 & 31u))];
                                let _e945 = firsts[(2u * _e934)];
                                let _e950 = firsts[((2u * _e934) + 1u)];
                                let _e954 = params.member.member_1.member_3;
                                let _e955 = (_e908 + _e928);
                                if (_e955 < _e954) {
                                    let _e957 = (2u * _e955);
                                    atomicStore((&output.member[(4u + _e957)]), (_e945 + ((_e931 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e957 + 5u)]), (_e950 + _e942));
                                }
                                phi_1532_ = true;
                            }
                            let _e963 = phi_1532_;
                            phi_1533_ = _e963;
                        } else {
                            phi_1533_ = false;
                        }
                        let _e965 = phi_1533_;
                        continue;
                        continuing {
                            phi_1459_ = type_9(select(_e910.member, (_e910.member + 1u), _e913), select(_e910.member_1, _e910.member_1, _e913));
                            break if !(_e965);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1213_ = type_9(select(_e758.member, (_e758.member + 1u), _e761), select(_e758.member_1, _e758.member_1, _e761));
                    break if !(_e774);
                }
            }
            phi_224_ = (_e100 + (_e43.x * _e43.y));
        } else {
            phi_224_ = u32();
        }
        let _e969 = phi_224_;
        continue;
        continuing {
            phi_223_ = _e969;
            break if !(_e106);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
