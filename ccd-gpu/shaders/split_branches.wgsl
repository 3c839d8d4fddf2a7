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

struct type_17 {
    member: array<vec4<u32>>,
}

struct type_18 {
    member: u32,
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

@group(0) @binding(1) 
var<storage> keys: type_11;
@group(0) @binding(0) 
var<storage> params: type_20;
var<workgroup> begins: array<u32, 256>;
@group(0) @binding(2) 
var<storage> levels: type_11;
@group(0) @binding(3) 
var<storage> present: type_11;
@group(0) @binding(4) 
var<storage> table: type_11;
@group(0) @binding(5) 
var<storage> entries: type_11;
@group(0) @binding(6) 
var<storage> list: type_11;
@group(0) @binding(7) 
var<storage, read_write> branches: type_17;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_133_: type_9;
    var phi_136_: u32;
    var phi_137_: u32;
    var local_1: u32;
    var phi_249_: type_9;
    var phi_252_: u32;
    var phi_253_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_353_: u32;
    var phi_370_: u32;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_525_: u32;
    var phi_527_: u32;
    var phi_581_: u32;
    var phi_583_: u32;
    var phi_590_: u32;
    var phi_652_: u32;
    var phi_654_: u32;
    var phi_591_: u32;
    var phi_661_: bool;
    var local_4: u32;
    var phi_668_: u32;
    var phi_671_: u32;
    var phi_733_: u32;
    var phi_735_: u32;
    var phi_669_: u32;
    var phi_672_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_796_: u32;
    var phi_798_: u32;
    var phi_800_: u32;
    var phi_803_: u32;
    var phi_881_: u32;
    var phi_883_: u32;
    var phi_801_: u32;
    var phi_804_: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e31 = id_2;
    let _e32 = n_2;
    let _e33 = lane_2;
    let _e48 = ((((_e31.y * _e32.x) + _e31.x) * 256u) + _e33);
    let _e51 = params.member.member_2.member;
    let _e55 = params.member.member.member[_e51];
    let _e56 = (_e55 - 1u);
    let _e57 = (_e56 / 256u);
    phi_133_ = type_9(0u, select(_e33, 96u, (96u < _e33)));
    phi_136_ = 0u;
    loop {
        let _e66 = phi_133_;
        let _e68 = phi_136_;
        local_1 = _e68;
        let _e71 = (_e66.member < _e66.member_1);
        let _e84 = (bitcast<i32>(select(0u, 1u, _e71)) != 0i);
        if _e84 {
            let _e88 = table.member[((256u * select(_e57, (_e57 + 1u), ((_e56 % 256u) > 0u))) + select(type_9().member_1, _e66.member, _e71))];
            phi_137_ = (_e68 + _e88);
        } else {
            phi_137_ = u32();
        }
        let _e91 = phi_137_;
        continue;
        continuing {
            phi_133_ = type_9(select(_e66.member, (_e66.member + 1u), _e71), select(_e66.member_1, _e66.member_1, _e71));
            phi_136_ = _e91;
            break if !(_e84);
        }
    }
    let _e95 = local_1;
    begins[_e33] = _e95;
    workgroupBarrier();
    let _e97 = list.member[0u];
    let _e100 = params.member.member_1.member_3;
    let _e101 = (_e97 <= _e100);
    if (_e48 < _e56) {
        if _e101 {
            let _e104 = levels.member[_e48];
            let _e106 = present.member[0u];
            let _e108 = present.member[1u];
            let _e110 = present.member[2u];
            local = array<u32, 3>(_e106, _e108, _e110);
            phi_249_ = type_9(0u, 3u);
            phi_252_ = 0u;
            loop {
                let _e113 = phi_249_;
                let _e115 = phi_252_;
                local_2 = _e115;
                local_3 = _e115;
                let _e118 = (_e113.member < _e113.member_1);
                let _e129 = select(type_9().member_1, _e113.member, _e118);
                let _e131 = (bitcast<i32>(select(0u, 1u, _e118)) != 0i);
                if _e131 {
                    let _e132 = (32u * _e129);
                    let _e144 = local[_e129];
                    phi_253_ = (_e115 + countOneBits((_e144 & select(select(0u, ((1u << bitcast<u32>(((_e104 - _e132) & 31u))) - 1u), (_e104 > _e132)), 4294967295u, (_e104 >= (_e132 + 32u))))));
                } else {
                    phi_253_ = u32();
                }
                let _e149 = phi_253_;
                continue;
                continuing {
                    phi_249_ = type_9(select(_e113.member, (_e113.member + 1u), _e118), select(_e113.member_1, _e113.member_1, _e118));
                    phi_252_ = _e149;
                    break if !(_e131);
                }
            }
            let _e152 = local_2;
            let _e154 = begins[_e152];
            let _e157 = local_3;
            let _e160 = begins[(_e157 + 1u)];
            let _e163 = entries.member[_e48];
            let _e164 = (4u + _e163);
            let _e166 = list.member[_e164];
            if (_e164 > (4u + _e154)) {
                let _e170 = list.member[(_e163 + 3u)];
                phi_353_ = (_e170 + 1u);
            } else {
                phi_353_ = 0u;
            }
            let _e173 = phi_353_;
            if ((_e163 + 5u) < (4u + _e160)) {
                let _e178 = list.member[(_e163 + 5u)];
                phi_370_ = _e178;
            } else {
                phi_370_ = _e56;
            }
            let _e180 = phi_370_;
            let _e181 = (_e173 == 0u);
            let _e182 = (_e180 == _e56);
            if _e181 {
                phi_402_ = true;
            } else {
                if _e182 {
                    phi_401_ = false;
                } else {
                    let _e184 = levels.member[_e180];
                    let _e187 = levels.member[(_e173 - 1u)];
                    phi_401_ = (_e184 > _e187);
                }
                let _e190 = phi_401_;
                phi_402_ = _e190;
            }
            let _e192 = phi_402_;
            let _e194 = levels.member[_e166];
            let _e201 = (_e166 + 1u);
            branches.member[select(select(0u, select(_e173, _e180, _e192), select(true, select(true, false, _e182), _e181)), 4294967295u, (_e194 != _e104))] = vec4<u32>(select(_e166, (_e56 + _e173), (_e173 == _e166)), select(_e201, (_e56 + _e201), (_e201 == _e180)), _e173, _e180);
        }
    }
    if (_e48 < _e56) {
        if _e101 {
        } else {
            let _e213 = params.member.member_2.member;
            let _e217 = params.member.member.member_2[_e213];
            if (1u < (_e55 - _e48)) {
                let _e220 = (_e48 + 1u);
                let _e223 = keys.member[(_e217 + _e48)];
                let _e226 = keys.member[(_e217 + _e220)];
                let _e227 = (_e223 ^ _e226);
                let _e232 = select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u));
                if (_e232 < 32u) {
                    phi_525_ = _e232;
                } else {
                    let _e234 = (_e48 ^ _e220);
                    phi_525_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e234)), 32u, (_e234 == 0u)));
                }
                let _e242 = phi_525_;
                phi_527_ = (1u + _e242);
            } else {
                phi_527_ = 0u;
            }
            let _e245 = phi_527_;
            if (1u <= _e48) {
                let _e247 = (_e48 - 1u);
                let _e250 = keys.member[(_e217 + _e48)];
                let _e253 = keys.member[(_e217 + _e247)];
                let _e254 = (_e250 ^ _e253);
                let _e259 = select((bitcast<u32>(31i) - firstLeadingBit(_e254)), 32u, (_e254 == 0u));
                if (_e259 < 32u) {
                    phi_581_ = _e259;
                } else {
                    let _e261 = (_e48 ^ _e247);
                    phi_581_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e261)), 32u, (_e261 == 0u)));
                }
                let _e269 = phi_581_;
                phi_583_ = (1u + _e269);
            } else {
                phi_583_ = 0u;
            }
            let _e272 = phi_583_;
            let _e273 = (_e245 > _e272);
            let _e274 = select(_e245, _e272, _e273);
            phi_590_ = 2u;
            loop {
                let _e276 = phi_590_;
                local_4 = _e276;
                if (_e276 < _e55) {
                    if select((_e276 <= _e48), (_e276 < (_e55 - _e48)), _e273) {
                        let _e284 = select((_e48 - _e276), (_e48 + _e276), _e273);
                        let _e287 = keys.member[(_e217 + _e48)];
                        let _e290 = keys.member[(_e217 + _e284)];
                        let _e291 = (_e287 ^ _e290);
                        let _e296 = select((bitcast<u32>(31i) - firstLeadingBit(_e291)), 32u, (_e291 == 0u));
                        if (_e296 < 32u) {
                            phi_652_ = _e296;
                        } else {
                            let _e298 = (_e48 ^ _e284);
                            phi_652_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e298)), 32u, (_e298 == 0u)));
                        }
                        let _e306 = phi_652_;
                        phi_654_ = (1u + _e306);
                    } else {
                        phi_654_ = 0u;
                    }
                    let _e309 = phi_654_;
                    let _e310 = (_e309 > _e274);
                    phi_591_ = select(u32(), (_e276 * 2u), _e310);
                    phi_661_ = _e310;
                } else {
                    phi_591_ = u32();
                    phi_661_ = false;
                }
                let _e314 = phi_591_;
                let _e316 = phi_661_;
                continue;
                continuing {
                    phi_590_ = _e314;
                    break if !(_e316);
                }
            }
            let _e319 = local_4;
            phi_668_ = (_e319 / 2u);
            phi_671_ = 0u;
            loop {
                let _e322 = phi_668_;
                let _e324 = phi_671_;
                local_5 = _e324;
                local_6 = _e324;
                local_7 = _e324;
                local_8 = _e324;
                local_13 = _e324;
                local_9 = _e324;
                local_10 = _e324;
                let _e325 = (_e322 > 0u);
                if _e325 {
                    let _e326 = (_e324 + _e322);
                    if select((_e326 <= _e48), (_e326 < (_e55 - _e48)), _e273) {
                        let _e333 = select((_e48 - _e326), (_e48 + _e326), _e273);
                        let _e336 = keys.member[(_e217 + _e48)];
                        let _e339 = keys.member[(_e217 + _e333)];
                        let _e340 = (_e336 ^ _e339);
                        let _e345 = select((bitcast<u32>(31i) - firstLeadingBit(_e340)), 32u, (_e340 == 0u));
                        if (_e345 < 32u) {
                            phi_733_ = _e345;
                        } else {
                            let _e347 = (_e48 ^ _e333);
                            phi_733_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e347)), 32u, (_e347 == 0u)));
                        }
                        let _e355 = phi_733_;
                        phi_735_ = (1u + _e355);
                    } else {
                        phi_735_ = 0u;
                    }
                    let _e358 = phi_735_;
                    phi_669_ = (_e322 / 2u);
                    phi_672_ = select(_e324, (_e324 + _e322), (_e358 > _e274));
                } else {
                    phi_669_ = u32();
                    phi_672_ = u32();
                }
                let _e364 = phi_669_;
                let _e366 = phi_672_;
                continue;
                continuing {
                    phi_668_ = _e364;
                    phi_671_ = _e366;
                    break if !(_e325);
                }
            }
            let _e370 = local_5;
            let _e373 = local_6;
            if select((_e373 <= _e48), (_e370 < (_e55 - _e48)), _e273) {
                let _e377 = local_7;
                let _e380 = local_8;
                let _e382 = select((_e48 - _e380), (_e48 + _e377), _e273);
                let _e385 = keys.member[(_e217 + _e48)];
                let _e388 = keys.member[(_e217 + _e382)];
                let _e389 = (_e385 ^ _e388);
                let _e394 = select((bitcast<u32>(31i) - firstLeadingBit(_e389)), 32u, (_e389 == 0u));
                if (_e394 < 32u) {
                    phi_796_ = _e394;
                } else {
                    let _e396 = (_e48 ^ _e382);
                    phi_796_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e396)), 32u, (_e396 == 0u)));
                }
                let _e404 = phi_796_;
                phi_798_ = (1u + _e404);
            } else {
                phi_798_ = 0u;
            }
            let _e407 = phi_798_;
            let _e522 = local_13;
            phi_800_ = _e522;
            phi_803_ = 0u;
            loop {
                let _e409 = phi_800_;
                let _e411 = phi_803_;
                local_11 = _e411;
                local_12 = _e411;
                let _e412 = (_e409 > 1u);
                if _e412 {
                    let _e413 = (_e409 / 2u);
                    let _e417 = select(_e413, (_e413 + 1u), ((_e409 % 2u) > 0u));
                    let _e418 = (_e411 + _e417);
                    if select((_e418 <= _e48), (_e418 < (_e55 - _e48)), _e273) {
                        let _e425 = select((_e48 - _e418), (_e48 + _e418), _e273);
                        let _e428 = keys.member[(_e217 + _e48)];
                        let _e431 = keys.member[(_e217 + _e425)];
                        let _e432 = (_e428 ^ _e431);
                        let _e437 = select((bitcast<u32>(31i) - firstLeadingBit(_e432)), 32u, (_e432 == 0u));
                        if (_e437 < 32u) {
                            phi_881_ = _e437;
                        } else {
                            let _e439 = (_e48 ^ _e425);
                            phi_881_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e439)), 32u, (_e439 == 0u)));
                        }
                        let _e447 = phi_881_;
                        phi_883_ = (1u + _e447);
                    } else {
                        phi_883_ = 0u;
                    }
                    let _e450 = phi_883_;
                    phi_801_ = _e417;
                    phi_804_ = select(_e411, (_e411 + _e417), (_e450 > _e407));
                } else {
                    phi_801_ = u32();
                    phi_804_ = u32();
                }
                let _e455 = phi_801_;
                let _e457 = phi_804_;
                continue;
                continuing {
                    phi_800_ = _e455;
                    phi_803_ = _e457;
                    break if !(_e412);
                }
            }
            let _e460 = local_9;
            let _e463 = local_10;
            let _e465 = select((_e48 - _e463), _e48, _e273);
            let _e466 = select(_e48, (_e48 + _e460), _e273);
            let _e468 = local_11;
            let _e472 = local_12;
            let _e474 = select((_e48 - _e472), ((_e48 + _e468) + 1u), _e273);
            let _e475 = (_e55 - 1u);
            let _e476 = (_e474 - 1u);
            branches.member[_e48] = vec4<u32>(select(_e476, (_e475 + _e465), (_e465 == _e476)), select(_e474, (_e475 + _e474), (_e474 == _e466)), _e465, _e466);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn split_branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
