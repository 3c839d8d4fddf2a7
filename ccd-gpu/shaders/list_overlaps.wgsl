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
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

struct type_19 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> nodes: type_21;
var<workgroup> columns: array<type_23, 128>;
var<workgroup> names: array<u32, 128>;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> output: type_28;
@group(0) @binding(2) 
var<storage> order: type_11;
var<workgroup> threads: array<atomic<u32>, 4>;
var<workgroup> entries: array<atomic<u32>, 4>;
var<workgroup> first: array<u32, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_168_: u32;
    var phi_195_: u32;
    var phi_291_: u32;
    var phi_331_: u32;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_492_: u32;
    var phi_493_: u32;
    var phi_498_: type_9;
    var phi_501_: u32;
    var phi_502_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_698_: u32;
    var phi_770_: u32;
    var phi_794_: u32;
    var phi_797_: u32;
    var phi_846_: type_9;
    var phi_795_: u32;
    var phi_798_: u32;
    var phi_861_: bool;
    var phi_292_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e34 = id_2;
    let _e35 = n_2;
    let _e36 = lane_2;
    if (_e36 < 4u) {
        atomicStore((&threads[_e36]), 0u);
        atomicStore((&entries[_e36]), 0u);
    }
    workgroupBarrier();
    let _e56 = params.member.member_1.member_2;
    let _e58 = input.member[0u];
    let _e60 = select(_e58, _e56, (_e56 < _e58));
    let _e63 = params.member.member_1.member_1;
    if (_e60 > _e63) {
        let _e67 = params.member.member_1.member_1;
        phi_168_ = (_e60 - _e67);
    } else {
        phi_168_ = 0u;
    }
    let _e70 = phi_168_;
    let _e73 = params.member.member_2.member_3;
    if (_e73 == 1u) {
        phi_195_ = _e70;
    } else {
        let _e77 = params.member.member_2.member_3;
        if (_e77 == 0u) {
            return;
        }
        let _e79 = (_e70 / _e77);
        if (_e77 == 0u) {
            return;
        }
        phi_195_ = select(_e79, (_e79 + 1u), ((_e70 % _e77) > 0u));
    }
    let _e86 = phi_195_;
    let _e89 = params.member.member_2.member_4;
    let _e91 = select(_e86, _e89, (_e89 < _e86));
    let _e93 = params.member.member_2.member_1;
    let _e94 = (_e93 == 0u);
    let _e95 = select(1u, 0u, _e94);
    let _e100 = params.member.member_2.member[1u][_e95];
    let _e104 = params.member.member_2.member[0u][_e95];
    let _e108 = params.member.member_2.member[0u][select(1u, 2u, _e94)];
    let _e109 = (_e36 % 32u);
    let _e111 = ((_e36 / 32u) * 32u);
    let _e114 = params.member.member_2.member_1;
    let _e115 = (_e114 == 0u);
    let _e121 = params.member.member.member_2[select(1u, 0u, _e115)];
    let _e125 = params.member.member.member_2[select(1u, 2u, _e115)];
    phi_291_ = ((_e34.y * _e35.x) + _e34.x);
    loop {
        let _e127 = phi_291_;
        let _e128 = (_e91 / 4u);
        let _e133 = (_e127 < select(_e128, (_e128 + 1u), ((_e91 % 4u) > 0u)));
        if _e133 {
            let _e136 = ((_e127 * 4u) + (_e36 / 32u));
            let _e138 = (_e136 < _e91);
            let _e141 = params.member.member_1.member_1;
            if _e138 {
                let _e144 = params.member.member_2.member_3;
                phi_331_ = (_e136 * _e144);
            } else {
                phi_331_ = 0u;
            }
            let _e147 = phi_331_;
            let _e149 = (2u * (_e141 + _e147));
            let _e152 = input.member[(4u + _e149)];
            let _e155 = input.member[(_e149 + 5u)];
            if _e138 {
                let _e158 = params.member.member_2.member_1;
                let _e159 = (_e158 == 1u);
                phi_369_ = select(bool(), (_e152 == _e155), _e159);
                phi_370_ = select(true, false, _e159);
            } else {
                phi_369_ = bool();
                phi_370_ = true;
            }
            let _e164 = phi_369_;
            let _e166 = phi_370_;
            let _e167 = select(_e164, false, _e166);
            let _e169 = ((_e152 * 32u) + _e109);
            let _e171 = ((_e155 * 32u) + _e109);
            let _e174 = nodes.member[(_e100 + _e152)];
            let _e189 = nodes.member[(_e108 + _e171)];
            if _e167 {
                phi_434_ = true;
            } else {
                if _e138 {
                    phi_433_ = ((((((_e189.member.x <= _e174.member_1.y) && (_e174.member.x <= _e189.member_1.y)) && (_e189.member.y <= _e174.member_2.x)) && (_e174.member.y <= _e189.member_2.x)) && (_e189.member_1.x <= _e174.member_2.y)) && (_e174.member_1.x <= _e189.member_2.y));
                } else {
                    phi_433_ = false;
                }
                let _e214 = phi_433_;
                phi_434_ = _e214;
            }
            let _e216 = phi_434_;
            if _e216 {
                let _e223 = atomicOr((&threads[(_e36 / 32u)]), (1u << bitcast<u32>(((_e36 % 32u) & 31u))));
            }
            workgroupBarrier();
            let _e226 = atomicLoad((&threads[(_e36 / 32u)]));
            let _e229 = nodes.member[(_e104 + _e169)];
            if _e216 {
                let _e249 = (_e111 + countOneBits((_e226 & ((1u << bitcast<u32>(((_e109 % 32u) & 31u))) - 1u))));
                columns[_e249] = type_23(array<f32, 3>(_e189.member.x, _e189.member.y, _e189.member_1.x), array<f32, 3>(_e189.member_1.y, _e189.member_2.x, _e189.member_2.y));
                names[_e249] = _e171;
            }
            workgroupBarrier();
            if _e167 {
                phi_492_ = 16u;
                phi_493_ = (_e109 + 1u);
            } else {
                phi_492_ = countOneBits(_e226);
                phi_493_ = 0u;
            }
            let _e258 = phi_492_;
            let _e260 = phi_493_;
            phi_498_ = type_9(0u, ((_e258 + 3u) / 4u));
            phi_501_ = 0u;
            loop {
                let _e265 = phi_498_;
                let _e267 = phi_501_;
                local = _e267;
                local_1 = _e267;
                local_2 = _e267;
                let _e270 = (_e265.member < _e265.member_1);
                let _e283 = (bitcast<i32>(select(0u, 1u, _e270)) != 0i);
                if _e283 {
                    let _e284 = (4u * select(type_9().member_1, _e265.member, _e270));
                    let _e289 = columns[(_e111 + ((_e260 + _e284) % 32u))];
                    let _e315 = columns[(_e111 + (((_e260 + _e284) + 1u) % 32u))];
                    let _e344 = columns[(_e111 + (((_e260 + _e284) + 2u) % 32u))];
                    let _e373 = columns[(_e111 + (((_e260 + _e284) + 3u) % 32u))];
                    phi_502_ = (_e267 | ((((select(0u, 1u, ((((((_e229.member.x <= _e289.member_1[0]) && (_e289.member[0] <= _e229.member_1.y)) && (_e229.member.y <= _e289.member_1[1])) && (_e289.member[1] <= _e229.member_2.x)) && (_e229.member_1.x <= _e289.member_1[2])) && (_e289.member[2] <= _e229.member_2.y))) | (select(0u, 1u, ((((((_e229.member.x <= _e315.member_1[0]) && (_e315.member[0] <= _e229.member_1.y)) && (_e229.member.y <= _e315.member_1[1])) && (_e315.member[1] <= _e229.member_2.x)) && (_e229.member_1.x <= _e315.member_1[2])) && (_e315.member[2] <= _e229.member_2.y))) << bitcast<u32>(1i))) | (select(0u, 1u, ((((((_e229.member.x <= _e344.member_1[0]) && (_e344.member[0] <= _e229.member_1.y)) && (_e229.member.y <= _e344.member_1[1])) && (_e344.member[1] <= _e229.member_2.x)) && (_e229.member_1.x <= _e344.member_1[2])) && (_e344.member[2] <= _e229.member_2.y))) << bitcast<u32>(2i))) | (select(0u, 1u, ((((((_e229.member.x <= _e373.member_1[0]) && (_e373.member[0] <= _e229.member_1.y)) && (_e229.member.y <= _e373.member_1[1])) && (_e373.member[1] <= _e229.member_2.x)) && (_e229.member_1.x <= _e373.member_1[2])) && (_e373.member[2] <= _e229.member_2.y))) << bitcast<u32>(3i))) << bitcast<u32>((_e284 & 31u))));
                } else {
                    phi_502_ = u32();
                }
                let _e402 = phi_502_;
                continue;
                continuing {
                    phi_498_ = type_9(select(_e265.member, (_e265.member + 1u), _e270), select(_e265.member_1, _e265.member_1, _e270));
                    phi_501_ = _e402;
                    break if !(_e283);
                }
            }
            if _e167 {
                let _e420 = local_2;
                phi_698_ = (_e420 & (65535u >> bitcast<u32>(((_e109 / 16u) & 31u))));
            } else {
                let _e410 = local;
                let _e413 = local_1;
                phi_698_ = select(_e413, (_e410 & ((1u << bitcast<u32>((_e258 & 31u))) - 1u)), (_e258 < 32u));
            }
            let _e423 = phi_698_;
            let _e424 = (_e260 & 31u);
            let _e432 = select(((_e423 << bitcast<u32>(_e424)) | (_e423 >> bitcast<u32>((32u - _e424)))), _e423, (_e424 == 0u));
            let _e434 = (_e36 / 32u);
            let _e436 = atomicAdd((&entries[_e434]), countOneBits(_e432));
            workgroupBarrier();
            if ((_e36 % 32u) == 0u) {
                let _e440 = atomicLoad((&entries[_e434]));
                if (_e440 > 0u) {
                    let _e444 = params.member.member.member_1;
                    if ((_e444 & 1024u) != 0u) {
                        let _e454 = atomicAdd((&output.member[0u]), _e440);
                        let _e455 = (_e454 + _e440);
                        let _e457 = select(_e455, 4294967295u, (_e455 < _e454));
                        let _e460 = params.member.member_1.member_3;
                        if (_e457 > _e460) {
                            let _e463 = atomicMax((&output.member[2u]), _e457);
                        }
                        phi_770_ = _e454;
                    } else {
                        let _e448 = atomicAdd((&output.member[0u]), _e440);
                        if ((_e448 + _e440) < _e448) {
                            let _e452 = atomicAdd((&output.member[2u]), 1u);
                        }
                        phi_770_ = _e448;
                    }
                    let _e465 = phi_770_;
                    first[_e434] = _e465;
                }
                atomicStore((&entries[_e434]), 0u);
                atomicStore((&threads[_e434]), 0u);
            }
            workgroupBarrier();
            let _e470 = first[_e434];
            if (_e432 == 0u) {
            } else {
                let _e475 = order.member[(_e121 + _e169)];
                let _e476 = (_e475 - _e121);
                phi_794_ = (_e470 + _e436);
                phi_797_ = _e432;
                loop {
                    let _e478 = phi_794_;
                    let _e480 = phi_797_;
                    if (_e480 == 0u) {
                        phi_795_ = u32();
                        phi_798_ = u32();
                        phi_861_ = false;
                    } else {
                        let _e487 = names[(_e111 + select(firstTrailingBit(_e480), 32u, (_e480 == 0u)))];
                        let _e492 = order.member[(_e125 + _e487)];
                        let _e493 = (_e492 - _e125);
                        let _e496 = params.member.member_1.member_3;
                        let _e499 = params.member.member_2.member_1;
                        if (_e499 == 1u) {
                            let _e502 = (_e476 < _e493);
                            phi_846_ = type_9(select(_e493, _e476, _e502), select(_e476, _e493, _e502));
                        } else {
                            phi_846_ = type_9(_e476, _e493);
                        }
                        let _e507 = phi_846_;
                        if (_e478 < _e496) {
                            let _e511 = (2u * _e478);
                            atomicStore((&output.member[(4u + _e511)]), _e507.member);
                            atomicStore((&output.member[(_e511 + 5u)]), _e507.member_1);
                        }
                        phi_795_ = (_e478 + 1u);
                        phi_798_ = (_e480 & (_e480 - 1u));
                        phi_861_ = true;
                    }
                    let _e518 = phi_795_;
                    let _e520 = phi_798_;
                    let _e522 = phi_861_;
                    continue;
                    continuing {
                        phi_794_ = _e518;
                        phi_797_ = _e520;
                        break if !(_e522);
                    }
                }
            }
            phi_292_ = (_e127 + (_e35.x * _e35.y));
        } else {
            phi_292_ = u32();
        }
        let _e525 = phi_292_;
        continue;
        continuing {
            phi_291_ = _e525;
            break if !(_e133);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_overlaps(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
