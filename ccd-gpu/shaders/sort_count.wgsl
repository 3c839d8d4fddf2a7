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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_17 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> keys: type_13;
@group(0) @binding(2) 
var<storage, read_write> table: type_17;
var<workgroup> counts: array<atomic<u32>, 1024>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_86_: type_9;
    var phi_129_: u32;
    var phi_171_: u32;
    var phi_187_: u32;
    var phi_203_: u32;
    var phi_219_: u32;
    var phi_235_: u32;
    var phi_251_: u32;
    var phi_267_: u32;
    var phi_283_: u32;
    var phi_299_: u32;
    var phi_315_: u32;
    var phi_331_: u32;
    var phi_347_: u32;
    var phi_363_: u32;
    var phi_379_: u32;
    var phi_395_: u32;
    var phi_411_: u32;
    var phi_419_: type_9;
    var phi_466_: type_9;
    var phi_513_: type_9;
    var phi_560_: type_9;
    var phi_607_: type_9;
    var phi_654_: type_9;
    var phi_701_: type_9;
    var phi_748_: type_9;
    var phi_795_: type_9;
    var phi_842_: type_9;
    var phi_889_: type_9;
    var phi_936_: type_9;
    var phi_983_: type_9;
    var phi_1030_: type_9;
    var phi_1077_: type_9;
    var phi_1124_: type_9;
    var phi_130_: u32;
    var phi_1167_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e32 = id_2;
    let _e33 = n_2;
    let _e34 = lane_2;
    phi_86_ = type_9(0u, 4u);
    loop {
        let _e47 = phi_86_;
        let _e50 = (_e47.member < _e47.member_1);
        let _e63 = (bitcast<i32>(select(0u, 1u, _e50)) != 0i);
        if _e63 {
            atomicStore((&counts[((select(type_9().member_1, _e47.member, _e50) * 256u) + _e34)]), 0u);
        }
        continue;
        continuing {
            phi_86_ = type_9(select(_e47.member, (_e47.member + 1u), _e50), select(_e47.member_1, _e47.member_1, _e50));
            break if !(_e63);
        }
    }
    workgroupBarrier();
    let _e70 = params.member.member_1.member;
    let _e73 = params.member.member_1.member_1;
    phi_129_ = (_e73 + ((_e32.y * _e33.x) + _e32.x));
    loop {
        let _e76 = phi_129_;
        let _e77 = (_e70 / 4096u);
        let _e82 = (_e76 < select(_e77, (_e77 + 1u), ((_e70 % 4096u) > 0u)));
        if _e82 {
            let _e84 = ((_e76 * 4096u) + _e34);
            if (_e84 < _e70) {
                let _e87 = keys.member[_e84];
                phi_171_ = _e87;
            } else {
                phi_171_ = 0u;
            }
            let _e89 = phi_171_;
            let _e90 = (_e84 + 256u);
            if (_e90 < _e70) {
                let _e93 = keys.member[_e90];
                phi_187_ = _e93;
            } else {
                phi_187_ = 0u;
            }
            let _e95 = phi_187_;
            let _e96 = (_e84 + 512u);
            if (_e96 < _e70) {
                let _e99 = keys.member[_e96];
                phi_203_ = _e99;
            } else {
                phi_203_ = 0u;
            }
            let _e101 = phi_203_;
            let _e102 = (_e84 + 768u);
            if (_e102 < _e70) {
                let _e105 = keys.member[_e102];
                phi_219_ = _e105;
            } else {
                phi_219_ = 0u;
            }
            let _e107 = phi_219_;
            let _e108 = (_e84 + 1024u);
            if (_e108 < _e70) {
                let _e111 = keys.member[_e108];
                phi_235_ = _e111;
            } else {
                phi_235_ = 0u;
            }
            let _e113 = phi_235_;
            let _e114 = (_e84 + 1280u);
            if (_e114 < _e70) {
                let _e117 = keys.member[_e114];
                phi_251_ = _e117;
            } else {
                phi_251_ = 0u;
            }
            let _e119 = phi_251_;
            let _e120 = (_e84 + 1536u);
            if (_e120 < _e70) {
                let _e123 = keys.member[_e120];
                phi_267_ = _e123;
            } else {
                phi_267_ = 0u;
            }
            let _e125 = phi_267_;
            let _e126 = (_e84 + 1792u);
            if (_e126 < _e70) {
                let _e129 = keys.member[_e126];
                phi_283_ = _e129;
            } else {
                phi_283_ = 0u;
            }
            let _e131 = phi_283_;
            let _e132 = (_e84 + 2048u);
            if (_e132 < _e70) {
                let _e135 = keys.member[_e132];
                phi_299_ = _e135;
            } else {
                phi_299_ = 0u;
            }
            let _e137 = phi_299_;
            let _e138 = (_e84 + 2304u);
            if (_e138 < _e70) {
                let _e141 = keys.member[_e138];
                phi_315_ = _e141;
            } else {
                phi_315_ = 0u;
            }
            let _e143 = phi_315_;
            let _e144 = (_e84 + 2560u);
            if (_e144 < _e70) {
                let _e147 = keys.member[_e144];
                phi_331_ = _e147;
            } else {
                phi_331_ = 0u;
            }
            let _e149 = phi_331_;
            let _e150 = (_e84 + 2816u);
            if (_e150 < _e70) {
                let _e153 = keys.member[_e150];
                phi_347_ = _e153;
            } else {
                phi_347_ = 0u;
            }
            let _e155 = phi_347_;
            let _e156 = (_e84 + 3072u);
            if (_e156 < _e70) {
                let _e159 = keys.member[_e156];
                phi_363_ = _e159;
            } else {
                phi_363_ = 0u;
            }
            let _e161 = phi_363_;
            let _e162 = (_e84 + 3328u);
            if (_e162 < _e70) {
                let _e165 = keys.member[_e162];
                phi_379_ = _e165;
            } else {
                phi_379_ = 0u;
            }
            let _e167 = phi_379_;
            let _e168 = (_e84 + 3584u);
            if (_e168 < _e70) {
                let _e171 = keys.member[_e168];
                phi_395_ = _e171;
            } else {
                phi_395_ = 0u;
            }
            let _e173 = phi_395_;
            let _e174 = (_e84 + 3840u);
            if (_e174 < _e70) {
                let _e177 = keys.member[_e174];
                phi_411_ = _e177;
            } else {
                phi_411_ = 0u;
            }
            let _e179 = phi_411_;
            if (_e84 < _e70) {
                phi_419_ = type_9(0u, 4u);
                loop {
                    let _e182 = phi_419_;
                    let _e185 = (_e182.member < _e182.member_1);
                    let _e196 = select(type_9().member_1, _e182.member, _e185);
                    let _e198 = (bitcast<i32>(select(0u, 1u, _e185)) != 0i);
                    if _e198 {
                        let _e207 = atomicAdd((&counts[((_e196 * 256u) + ((_e89 >> bitcast<u32>(((8u * _e196) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_419_ = type_9(select(_e182.member, (_e182.member + 1u), _e185), select(_e182.member_1, _e182.member_1, _e185));
                        break if !(_e198);
                    }
                }
            }
            if ((_e84 + 256u) < _e70) {
                phi_466_ = type_9(0u, 4u);
                loop {
                    let _e212 = phi_466_;
                    let _e215 = (_e212.member < _e212.member_1);
                    let _e226 = select(type_9().member_1, _e212.member, _e215);
                    let _e228 = (bitcast<i32>(select(0u, 1u, _e215)) != 0i);
                    if _e228 {
                        let _e237 = atomicAdd((&counts[((_e226 * 256u) + ((_e95 >> bitcast<u32>(((8u * _e226) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_466_ = type_9(select(_e212.member, (_e212.member + 1u), _e215), select(_e212.member_1, _e212.member_1, _e215));
                        break if !(_e228);
                    }
                }
            }
            if ((_e84 + 512u) < _e70) {
                phi_513_ = type_9(0u, 4u);
                loop {
                    let _e242 = phi_513_;
                    let _e245 = (_e242.member < _e242.member_1);
                    let _e256 = select(type_9().member_1, _e242.member, _e245);
                    let _e258 = (bitcast<i32>(select(0u, 1u, _e245)) != 0i);
                    if _e258 {
                        let _e267 = atomicAdd((&counts[((_e256 * 256u) + ((_e101 >> bitcast<u32>(((8u * _e256) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_513_ = type_9(select(_e242.member, (_e242.member + 1u), _e245), select(_e242.member_1, _e242.member_1, _e245));
                        break if !(_e258);
                    }
                }
            }
            if ((_e84 + 768u) < _e70) {
                phi_560_ = type_9(0u, 4u);
                loop {
                    let _e272 = phi_560_;
                    let _e275 = (_e272.member < _e272.member_1);
                    let _e286 = select(type_9().member_1, _e272.member, _e275);
                    let _e288 = (bitcast<i32>(select(0u, 1u, _e275)) != 0i);
                    if _e288 {
                        let _e297 = atomicAdd((&counts[((_e286 * 256u) + ((_e107 >> bitcast<u32>(((8u * _e286) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_560_ = type_9(select(_e272.member, (_e272.member + 1u), _e275), select(_e272.member_1, _e272.member_1, _e275));
                        break if !(_e288);
                    }
                }
            }
            if ((_e84 + 1024u) < _e70) {
                phi_607_ = type_9(0u, 4u);
                loop {
                    let _e302 = phi_607_;
                    let _e305 = (_e302.member < _e302.member_1);
                    let _e316 = select(type_9().member_1, _e302.member, _e305);
                    let _e318 = (bitcast<i32>(select(0u, 1u, _e305)) != 0i);
                    if _e318 {
                        let _e327 = atomicAdd((&counts[((_e316 * 256u) + ((_e113 >> bitcast<u32>(((8u * _e316) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_607_ = type_9(select(_e302.member, (_e302.member + 1u), _e305), select(_e302.member_1, _e302.member_1, _e305));
                        break if !(_e318);
                    }
                }
            }
            if ((_e84 + 1280u) < _e70) {
                phi_654_ = type_9(0u, 4u);
                loop {
                    let _e332 = phi_654_;
                    let _e335 = (_e332.member < _e332.member_1);
                    let _e346 = select(type_9().member_1, _e332.member, _e335);
                    let _e348 = (bitcast<i32>(select(0u, 1u, _e335)) != 0i);
                    if _e348 {
                        let _e357 = atomicAdd((&counts[((_e346 * 256u) + ((_e119 >> bitcast<u32>(((8u * _e346) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_654_ = type_9(select(_e332.member, (_e332.member + 1u), _e335), select(_e332.member_1, _e332.member_1, _e335));
                        break if !(_e348);
                    }
                }
            }
            if ((_e84 + 1536u) < _e70) {
                phi_701_ = type_9(0u, 4u);
                loop {
                    let _e362 = phi_701_;
                    let _e365 = (_e362.member < _e362.member_1);
                    let _e376 = select(type_9().member_1, _e362.member, _e365);
                    let _e378 = (bitcast<i32>(select(0u, 1u, _e365)) != 0i);
                    if _e378 {
                        let _e387 = atomicAdd((&counts[((_e376 * 256u) + ((_e125 >> bitcast<u32>(((8u * _e376) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_701_ = type_9(select(_e362.member, (_e362.member + 1u), _e365), select(_e362.member_1, _e362.member_1, _e365));
                        break if !(_e378);
                    }
                }
            }
            if ((_e84 + 1792u) < _e70) {
                phi_748_ = type_9(0u, 4u);
                loop {
                    let _e392 = phi_748_;
                    let _e395 = (_e392.member < _e392.member_1);
                    let _e406 = select(type_9().member_1, _e392.member, _e395);
                    let _e408 = (bitcast<i32>(select(0u, 1u, _e395)) != 0i);
                    if _e408 {
                        let _e417 = atomicAdd((&counts[((_e406 * 256u) + ((_e131 >> bitcast<u32>(((8u * _e406) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_748_ = type_9(select(_e392.member, (_e392.member + 1u), _e395), select(_e392.member_1, _e392.member_1, _e395));
                        break if !(_e408);
                    }
                }
            }
            if ((_e84 + 2048u) < _e70) {
                phi_795_ = type_9(0u, 4u);
                loop {
                    let _e422 = phi_795_;
                    let _e425 = (_e422.member < _e422.member_1);
                    let _e436 = select(type_9().member_1, _e422.member, _e425);
                    let _e438 = (bitcast<i32>(select(0u, 1u, _e425)) != 0i);
                    if _e438 {
                        let _e447 = atomicAdd((&counts[((_e436 * 256u) + ((_e137 >> bitcast<u32>(((8u * _e436) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_795_ = type_9(select(_e422.member, (_e422.member + 1u), _e425), select(_e422.member_1, _e422.member_1, _e425));
                        break if !(_e438);
                    }
                }
            }
            if ((_e84 + 2304u) < _e70) {
                phi_842_ = type_9(0u, 4u);
                loop {
                    let _e452 = phi_842_;
                    let _e455 = (_e452.member < _e452.member_1);
                    let _e466 = select(type_9().member_1, _e452.member, _e455);
                    let _e468 = (bitcast<i32>(select(0u, 1u, _e455)) != 0i);
                    if _e468 {
                        let _e477 = atomicAdd((&counts[((_e466 * 256u) + ((_e143 >> bitcast<u32>(((8u * _e466) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_842_ = type_9(select(_e452.member, (_e452.member + 1u), _e455), select(_e452.member_1, _e452.member_1, _e455));
                        break if !(_e468);
                    }
                }
            }
            if ((_e84 + 2560u) < _e70) {
                phi_889_ = type_9(0u, 4u);
                loop {
                    let _e482 = phi_889_;
                    let _e485 = (_e482.member < _e482.member_1);
                    let _e496 = select(type_9().member_1, _e482.member, _e485);
                    let _e498 = (bitcast<i32>(select(0u, 1u, _e485)) != 0i);
                    if _e498 {
                        let _e507 = atomicAdd((&counts[((_e496 * 256u) + ((_e149 >> bitcast<u32>(((8u * _e496) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_889_ = type_9(select(_e482.member, (_e482.member + 1u), _e485), select(_e482.member_1, _e482.member_1, _e485));
                        break if !(_e498);
                    }
                }
            }
            if ((_e84 + 2816u) < _e70) {
                phi_936_ = type_9(0u, 4u);
                loop {
                    let _e512 = phi_936_;
                    let _e515 = (_e512.member < _e512.member_1);
                    let _e526 = select(type_9().member_1, _e512.member, _e515);
                    let _e528 = (bitcast<i32>(select(0u, 1u, _e515)) != 0i);
                    if _e528 {
                        let _e537 = atomicAdd((&counts[((_e526 * 256u) + ((_e155 >> bitcast<u32>(((8u * _e526) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_936_ = type_9(select(_e512.member, (_e512.member + 1u), _e515), select(_e512.member_1, _e512.member_1, _e515));
                        break if !(_e528);
                    }
                }
            }
            if ((_e84 + 3072u) < _e70) {
                phi_983_ = type_9(0u, 4u);
                loop {
                    let _e542 = phi_983_;
                    let _e545 = (_e542.member < _e542.member_1);
                    let _e556 = select(type_9().member_1, _e542.member, _e545);
                    let _e558 = (bitcast<i32>(select(0u, 1u, _e545)) != 0i);
                    if _e558 {
                        let _e567 = atomicAdd((&counts[((_e556 * 256u) + ((_e161 >> bitcast<u32>(((8u * _e556) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_983_ = type_9(select(_e542.member, (_e542.member + 1u), _e545), select(_e542.member_1, _e542.member_1, _e545));
                        break if !(_e558);
                    }
                }
            }
            if ((_e84 + 3328u) < _e70) {
                phi_1030_ = type_9(0u, 4u);
                loop {
                    let _e572 = phi_1030_;
                    let _e575 = (_e572.member < _e572.member_1);
                    let _e586 = select(type_9().member_1, _e572.member, _e575);
                    let _e588 = (bitcast<i32>(select(0u, 1u, _e575)) != 0i);
                    if _e588 {
                        let _e597 = atomicAdd((&counts[((_e586 * 256u) + ((_e167 >> bitcast<u32>(((8u * _e586) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_1030_ = type_9(select(_e572.member, (_e572.member + 1u), _e575), select(_e572.member_1, _e572.member_1, _e575));
                        break if !(_e588);
                    }
                }
            }
            if ((_e84 + 3584u) < _e70) {
                phi_1077_ = type_9(0u, 4u);
                loop {
                    let _e602 = phi_1077_;
                    let _e605 = (_e602.member < _e602.member_1);
                    let _e616 = select(type_9().member_1, _e602.member, _e605);
                    let _e618 = (bitcast<i32>(select(0u, 1u, _e605)) != 0i);
                    if _e618 {
                        let _e627 = atomicAdd((&counts[((_e616 * 256u) + ((_e173 >> bitcast<u32>(((8u * _e616) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_1077_ = type_9(select(_e602.member, (_e602.member + 1u), _e605), select(_e602.member_1, _e602.member_1, _e605));
                        break if !(_e618);
                    }
                }
            }
            if ((_e84 + 3840u) < _e70) {
                phi_1124_ = type_9(0u, 4u);
                loop {
                    let _e632 = phi_1124_;
                    let _e635 = (_e632.member < _e632.member_1);
                    let _e646 = select(type_9().member_1, _e632.member, _e635);
                    let _e648 = (bitcast<i32>(select(0u, 1u, _e635)) != 0i);
                    if _e648 {
                        let _e657 = atomicAdd((&counts[((_e646 * 256u) + ((_e179 >> bitcast<u32>(((8u * _e646) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_1124_ = type_9(select(_e632.member, (_e632.member + 1u), _e635), select(_e632.member_1, _e632.member_1, _e635));
                        break if !(_e648);
                    }
                }
            }
            phi_130_ = (_e76 + (_e33.x * _e33.y));
        } else {
            phi_130_ = u32();
        }
        let _e661 = phi_130_;
        continue;
        continuing {
            phi_129_ = _e661;
            break if !(_e82);
        }
    }
    workgroupBarrier();
    phi_1167_ = type_9(0u, 4u);
    loop {
        let _e664 = phi_1167_;
        let _e667 = (_e664.member < _e664.member_1);
        let _e680 = (bitcast<i32>(select(0u, 1u, _e667)) != 0i);
        if _e680 {
            let _e682 = ((select(type_9().member_1, _e664.member, _e667) * 256u) + _e34);
            let _e684 = atomicLoad((&counts[_e682]));
            if (_e684 > 0u) {
                let _e687 = atomicAdd((&table.member[_e682]), _e684);
            }
        }
        continue;
        continuing {
            phi_1167_ = type_9(select(_e664.member, (_e664.member + 1u), _e667), select(_e664.member_1, _e664.member_1, _e667));
            break if !(_e680);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
