// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_6 {
    member: i32,
    member_1: i32,
}

struct type_7 {
    member: u32,
    member_1: i32,
}

struct type_9 {
    member: array<array<u32, 2>>,
}

struct type_12 {
    member: array<array<u32, 24>>,
}

@group(0) @binding(0) 
var<storage> inputs: type_9;
@group(0) @binding(1) 
var<storage, read_write> results: type_12;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_108_: f32;
    var phi_114_: f32;
    var phi_120_: f32;
    var phi_148_: type_6;
    var phi_151_: f32;
    var phi_172_: bool;
    var phi_178_: type_7;
    var phi_149_: type_6;
    var phi_192_: type_7;
    var phi_152_: f32;
    var local: f32;
    var phi_141_: f32;
    var phi_205_: f32;
    var phi_217_: bool;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_249_: bool;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_290_: u32;
    var phi_291_: bool;
    var phi_292_: u32;
    var phi_293_: bool;
    var phi_297_: u32;
    var phi_308_: u32;
    var phi_316_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e35 = id_2;
    let _e36 = n_2;
    let _e37 = lane_2;
    let _e48 = ((((_e35.y * _e36.x) + _e35.x) * 64u) + _e37);
    if (_e48 < arrayLength((&inputs.member))) {
        let _e51 = inputs.member[_e48];
        let _e54 = bitcast<f32>(_e51[0]);
        let _e55 = bitcast<f32>(_e51[1]);
        if (_e54 < 0f) {
            phi_108_ = -(_e54);
        } else {
            phi_108_ = _e54;
        }
        let _e69 = phi_108_;
        if (_e54 < _e55) {
            phi_114_ = _e54;
        } else {
            phi_114_ = _e55;
        }
        let _e73 = phi_114_;
        if (_e54 > _e55) {
            phi_120_ = _e54;
        } else {
            phi_120_ = _e55;
        }
        let _e77 = phi_120_;
        if (_e54 <= 0.000000000000000000000000000000000000011754944f) {
            if (_e54 > 0f) {
                phi_141_ = (0.000000000000000000106433627f * 2f);
            } else {
                phi_141_ = 0f;
            }
            let _e137 = phi_141_;
            phi_205_ = _e137;
        } else {
            phi_148_ = type_6(0i, 5i);
            phi_151_ = bitcast<f32>(((bitcast<u32>(_e54) >> bitcast<u32>(1i)) + 532369198u));
            loop {
                let _e92 = phi_148_;
                let _e94 = phi_151_;
                local = _e94;
                if (_e92.member < _e92.member_1) {
                    let _e101 = (_e92.member + 1i);
                    if ((false == (_e101 > _e92.member)) != false) {
                        phi_172_ = true;
                    } else {
                        phi_172_ = false;
                    }
                    let _e106 = phi_172_;
                    if _e106 {
                        phi_178_ = type_7(0u, type_7().member_1);
                    } else {
                        phi_178_ = type_7(1u, _e101);
                    }
                    let _e111 = phi_178_;
                    phi_149_ = type_6(_e111.member_1, _e92.member_1);
                    phi_192_ = type_7(1u, _e92.member);
                } else {
                    phi_149_ = _e92;
                    phi_192_ = type_7(0u, type_7().member_1);
                }
                let _e117 = phi_149_;
                let _e119 = phi_192_;
                let _e122 = (bitcast<i32>(_e119.member) != 0i);
                if _e122 {
                    phi_152_ = (0.5f * (_e94 + (_e54 / _e94)));
                } else {
                    phi_152_ = f32();
                }
                let _e127 = phi_152_;
                continue;
                continuing {
                    phi_148_ = _e117;
                    phi_151_ = _e127;
                    break if !(_e122);
                }
            }
            let _e132 = local;
            phi_205_ = (_e132 * (1f + (8f * 0.000000059604645f)));
        }
        let _e139 = phi_205_;
        let _e141 = bitcast<u32>(_e54);
        if ((_e141 & 2139095040u) == 2139095040u) {
            phi_217_ = (_e54 < 0f);
        } else {
            phi_217_ = true;
        }
        let _e146 = phi_217_;
        if _e146 {
            if (_e54 > 0f) {
                phi_235_ = bitcast<f32>((_e141 + 1u));
            } else {
                if (_e54 < 0f) {
                    phi_234_ = bitcast<f32>((_e141 - 1u));
                } else {
                    phi_234_ = 0.000000000000000000000000000000000000000000001f;
                }
                let _e152 = phi_234_;
                phi_235_ = _e152;
            }
            let _e156 = phi_235_;
            phi_236_ = _e156;
        } else {
            phi_236_ = _e54;
        }
        let _e158 = phi_236_;
        let _e160 = -(_e54);
        let _e161 = bitcast<u32>(_e160);
        if ((_e161 & 2139095040u) == 2139095040u) {
            phi_249_ = (_e160 < 0f);
        } else {
            phi_249_ = true;
        }
        let _e166 = phi_249_;
        if _e166 {
            if (_e160 > 0f) {
                phi_267_ = bitcast<f32>((_e161 + 1u));
            } else {
                if (_e160 < 0f) {
                    phi_266_ = bitcast<f32>((_e161 - 1u));
                } else {
                    phi_266_ = 0.000000000000000000000000000000000000000000001f;
                }
                let _e172 = phi_266_;
                phi_267_ = _e172;
            }
            let _e176 = phi_267_;
            phi_268_ = _e176;
        } else {
            phi_268_ = _e160;
        }
        let _e178 = phi_268_;
        if (_e54 > 0f) {
            if (_e54 < 4000000000f) {
                phi_290_ = select(select(u32(_e54), 0u, (_e54 < 0f)), 4294967295u, (_e54 > 4294967000f));
                phi_291_ = false;
            } else {
                phi_290_ = u32();
                phi_291_ = true;
            }
            let _e193 = phi_290_;
            let _e195 = phi_291_;
            phi_292_ = _e193;
            phi_293_ = _e195;
        } else {
            phi_292_ = u32();
            phi_293_ = true;
        }
        let _e197 = phi_292_;
        let _e199 = phi_293_;
        if _e199 {
            phi_297_ = 0u;
        } else {
            phi_297_ = _e197;
        }
        let _e201 = phi_297_;
        let _e204 = bitcast<u32>(_e54);
        if ((_e204 >> bitcast<u32>(31i)) == 1u) {
            phi_308_ = ~(_e204);
        } else {
            phi_308_ = (_e204 | 2147483648u);
        }
        let _e211 = phi_308_;
        if ((_e51[0] >> bitcast<u32>(31i)) == 1u) {
            phi_316_ = (_e51[0] & 2147483647u);
        } else {
            phi_316_ = ~(_e51[0]);
        }
        let _e218 = phi_316_;
        results.member[_e48] = array<u32, 24>(bitcast<u32>((_e54 + _e55)), bitcast<u32>((_e54 - _e55)), bitcast<u32>((_e54 * _e55)), bitcast<u32>((_e54 / _e55)), bitcast<u32>(-(_e54)), bitcast<u32>(_e69), bitcast<u32>(_e73), bitcast<u32>(_e77), select(0u, 1u, (_e54 < _e55)), select(0u, 1u, (_e54 <= _e55)), select(0u, 1u, (_e54 == _e55)), bitcast<u32>(_e139), bitcast<u32>(_e158), bitcast<u32>(-(_e178)), select(0u, 1u, ((bitcast<u32>(_e54) & 2139095040u) != 2139095040u)), _e201, bitcast<u32>(f32(_e51[0])), _e211, bitcast<u32>(bitcast<f32>(_e218)), select((bitcast<u32>(31i) - firstLeadingBit(_e51[0])), 32u, (_e51[0] == 0u)), select(firstTrailingBit(_e51[0]), 32u, (_e51[0] == 0u)), countOneBits(_e51[0]), (_e51[0] * _e51[1]), ((_e51[0] << bitcast<u32>(((_e51[1] & 31u) & 31u))) ^ (_e51[0] >> bitcast<u32>(((_e51[1] & 31u) & 31u)))));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_scalars(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
