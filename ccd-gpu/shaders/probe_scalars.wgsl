struct type_8 {
    member: array<array<u32, 2>>,
}

struct type_13 {
    member: i32,
    member_1: i32,
}

struct type_14 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<array<u32, 24>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(1) 
var<storage, read_write> out: type_18;
@group(0) @binding(0) 
var<storage> inputs: type_8;

fn function_() {
    var phi_108_: f32;
    var phi_114_: f32;
    var phi_120_: f32;
    var phi_148_: type_13;
    var phi_151_: f32;
    var phi_172_: bool;
    var phi_178_: type_14;
    var phi_149_: type_13;
    var phi_192_: type_14;
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

    let _e38 = id_1;
    let _e39 = n_1;
    let _e40 = lane_1;
    let _e51 = ((((_e38.y * _e39.x) + _e38.x) * 64u) + _e40);
    if (_e51 < arrayLength((&inputs.member))) {
        let _e54 = inputs.member[_e51];
        let _e57 = bitcast<f32>(_e54[0]);
        let _e58 = bitcast<f32>(_e54[1]);
        if (_e57 < 0f) {
            phi_108_ = -(_e57);
        } else {
            phi_108_ = _e57;
        }
        let _e72 = phi_108_;
        if (_e57 < _e58) {
            phi_114_ = _e57;
        } else {
            phi_114_ = _e58;
        }
        let _e76 = phi_114_;
        if (_e57 > _e58) {
            phi_120_ = _e57;
        } else {
            phi_120_ = _e58;
        }
        let _e80 = phi_120_;
        if (_e57 <= 0.000000000000000000000000000000000000011754944f) {
            if (_e57 > 0f) {
                phi_141_ = (0.000000000000000000106433627f * 2f);
            } else {
                phi_141_ = 0f;
            }
            let _e146 = phi_141_;
            phi_205_ = _e146;
        } else {
            phi_148_ = type_13(0i, 5i);
            phi_151_ = bitcast<f32>(((bitcast<u32>(_e57) >> bitcast<u32>(1i)) + 532369198u));
            loop {
                let _e95 = phi_148_;
                let _e97 = phi_151_;
                local = _e97;
                if (_e95.member < _e95.member_1) {
                    let _e105 = (_e95.member + 1i);
                    if ((false == (_e105 > _e95.member)) != false) {
                        phi_172_ = true;
                    } else {
                        phi_172_ = false;
                    }
                    let _e110 = phi_172_;
                    if _e110 {
                        phi_178_ = type_14(0u, type_14().member_1);
                    } else {
                        phi_178_ = type_14(1u, _e105);
                    }
                    let _e116 = phi_178_;
                    if (bitcast<i32>(_e116.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_149_ = type_13(_e116.member_1, _e95.member_1);
                    phi_192_ = type_14(1u, _e95.member);
                } else {
                    phi_149_ = _e95;
                    phi_192_ = type_14(0u, type_14().member_1);
                }
                let _e126 = phi_149_;
                let _e128 = phi_192_;
                let _e131 = (bitcast<i32>(_e128.member) != 0i);
                if _e131 {
                    phi_152_ = (0.5f * (_e97 + (_e57 / _e97)));
                } else {
                    phi_152_ = f32();
                }
                let _e136 = phi_152_;
                continue;
                continuing {
                    phi_148_ = _e126;
                    phi_151_ = _e136;
                    break if !(_e131);
                }
            }
            let _e141 = local;
            phi_205_ = (_e141 * (1f + (8f * 0.000000059604645f)));
        }
        let _e148 = phi_205_;
        let _e150 = bitcast<u32>(_e57);
        if ((_e150 & 2139095040u) == 2139095040u) {
            phi_217_ = (_e57 < 0f);
        } else {
            phi_217_ = true;
        }
        let _e155 = phi_217_;
        if _e155 {
            if (_e57 > 0f) {
                phi_235_ = bitcast<f32>((_e150 + 1u));
            } else {
                if (_e57 < 0f) {
                    phi_234_ = bitcast<f32>((_e150 - 1u));
                } else {
                    phi_234_ = 0.000000000000000000000000000000000000000000001f;
                }
                let _e161 = phi_234_;
                phi_235_ = _e161;
            }
            let _e165 = phi_235_;
            phi_236_ = _e165;
        } else {
            phi_236_ = _e57;
        }
        let _e167 = phi_236_;
        let _e169 = -(_e57);
        let _e170 = bitcast<u32>(_e169);
        if ((_e170 & 2139095040u) == 2139095040u) {
            phi_249_ = (_e169 < 0f);
        } else {
            phi_249_ = true;
        }
        let _e175 = phi_249_;
        if _e175 {
            if (_e169 > 0f) {
                phi_267_ = bitcast<f32>((_e170 + 1u));
            } else {
                if (_e169 < 0f) {
                    phi_266_ = bitcast<f32>((_e170 - 1u));
                } else {
                    phi_266_ = 0.000000000000000000000000000000000000000000001f;
                }
                let _e181 = phi_266_;
                phi_267_ = _e181;
            }
            let _e185 = phi_267_;
            phi_268_ = _e185;
        } else {
            phi_268_ = _e169;
        }
        let _e187 = phi_268_;
        if (_e57 > 0f) {
            if (_e57 < 4000000000f) {
                phi_290_ = select(select(u32(_e57), 0u, (_e57 < 0f)), 4294967295u, (_e57 > 4294967000f));
                phi_291_ = false;
            } else {
                phi_290_ = u32();
                phi_291_ = true;
            }
            let _e202 = phi_290_;
            let _e204 = phi_291_;
            phi_292_ = _e202;
            phi_293_ = _e204;
        } else {
            phi_292_ = u32();
            phi_293_ = true;
        }
        let _e206 = phi_292_;
        let _e208 = phi_293_;
        if _e208 {
            phi_297_ = 0u;
        } else {
            phi_297_ = _e206;
        }
        let _e210 = phi_297_;
        let _e213 = bitcast<u32>(_e57);
        if ((_e213 >> bitcast<u32>(31i)) == 1u) {
            phi_308_ = ~(_e213);
        } else {
            phi_308_ = (_e213 | 2147483648u);
        }
        let _e220 = phi_308_;
        if ((_e54[0] >> bitcast<u32>(31i)) == 1u) {
            phi_316_ = (_e54[0] & 2147483647u);
        } else {
            phi_316_ = ~(_e54[0]);
        }
        let _e227 = phi_316_;
        out.member[_e51] = array<u32, 24>(bitcast<u32>((_e57 + _e58)), bitcast<u32>((_e57 - _e58)), bitcast<u32>((_e57 * _e58)), bitcast<u32>((_e57 / _e58)), bitcast<u32>(-(_e57)), bitcast<u32>(_e72), bitcast<u32>(_e76), bitcast<u32>(_e80), select(0u, 1u, (_e57 < _e58)), select(0u, 1u, (_e57 <= _e58)), select(0u, 1u, (_e57 == _e58)), bitcast<u32>(_e148), bitcast<u32>(_e167), bitcast<u32>(-(_e187)), select(0u, 1u, ((bitcast<u32>(_e57) & 2139095040u) != 2139095040u)), _e210, bitcast<u32>(f32(_e54[0])), _e220, bitcast<u32>(bitcast<f32>(_e227)), select((bitcast<u32>(31i) - firstLeadingBit(_e54[0])), 32u, (_e54[0] == 0u)), select(firstTrailingBit(_e54[0]), 32u, (_e54[0] == 0u)), countOneBits(_e54[0]), (_e54[0] * _e54[1]), ((_e54[0] << bitcast<u32>(((_e54[1] & 31u) & 31u))) ^ (_e54[0] >> bitcast<u32>(((_e54[1] & 31u) & 31u)))));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_scalars(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
