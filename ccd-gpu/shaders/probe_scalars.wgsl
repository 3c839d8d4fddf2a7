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
    var phi_148_: type_6;
    var phi_151_: f32;
    var phi_149_: type_6;
    var phi_192_: type_7;
    var phi_152_: f32;
    var local: f32;
    var phi_205_: f32;
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
        if (_e54 <= 0.000000000000000000000000000000000000011754944f) {
            phi_205_ = select(0f, (0.000000000000000000106433627f * 2f), (_e54 > 0f));
        } else {
            phi_148_ = type_6(0i, 5i);
            phi_151_ = bitcast<f32>(((bitcast<u32>(_e54) >> bitcast<u32>(1i)) + 532369198u));
            loop {
                let _e89 = phi_148_;
                let _e91 = phi_151_;
                local = _e91;
                if (_e89.member < _e89.member_1) {
                    let _e98 = (_e89.member + 1i);
                    phi_149_ = type_6(select(_e98, type_7().member_1, select(false, true, ((false == (_e98 > _e89.member)) != false))), _e89.member_1);
                    phi_192_ = type_7(1u, _e89.member);
                } else {
                    phi_149_ = _e89;
                    phi_192_ = type_7(0u, type_7().member_1);
                }
                let _e109 = phi_149_;
                let _e111 = phi_192_;
                let _e114 = (bitcast<i32>(_e111.member) != 0i);
                if _e114 {
                    phi_152_ = (0.5f * (_e91 + (_e54 / _e91)));
                } else {
                    phi_152_ = f32();
                }
                let _e119 = phi_152_;
                continue;
                continuing {
                    phi_148_ = _e109;
                    phi_151_ = _e119;
                    break if !(_e114);
                }
            }
            let _e124 = local;
            phi_205_ = (_e124 * (1f + (8f * 0.000000059604645f)));
        }
        let _e130 = phi_205_;
        let _e132 = bitcast<u32>(_e54);
        let _e147 = -(_e54);
        let _e148 = bitcast<u32>(_e147);
        let _e168 = (_e54 > 0f);
        let _e169 = (_e54 < 4000000000f);
        let _e182 = bitcast<u32>(_e54);
        results.member[_e48] = array<u32, 24>(bitcast<u32>((_e54 + _e55)), bitcast<u32>((_e54 - _e55)), bitcast<u32>((_e54 * _e55)), bitcast<u32>((_e54 / _e55)), bitcast<u32>(-(_e54)), bitcast<u32>(select(_e54, -(_e54), (_e54 < 0f))), bitcast<u32>(select(_e55, _e54, (_e54 < _e55))), bitcast<u32>(select(_e55, _e54, (_e54 > _e55))), select(0u, 1u, (_e54 < _e55)), select(0u, 1u, (_e54 <= _e55)), select(0u, 1u, (_e54 == _e55)), bitcast<u32>(_e130), bitcast<u32>(select(_e54, select(select(0.000000000000000000000000000000000000000000001f, bitcast<f32>((_e132 - 1u)), (_e54 < 0f)), bitcast<f32>((_e132 + 1u)), (_e54 > 0f)), select(true, (_e54 < 0f), ((_e132 & 2139095040u) == 2139095040u)))), bitcast<u32>(-(select(_e147, select(select(0.000000000000000000000000000000000000000000001f, bitcast<f32>((_e148 - 1u)), (_e147 < 0f)), bitcast<f32>((_e148 + 1u)), (_e147 > 0f)), select(true, (_e147 < 0f), ((_e148 & 2139095040u) == 2139095040u))))), select(0u, 1u, ((bitcast<u32>(_e54) & 2139095040u) != 2139095040u)), select(select(u32(), select(u32(), select(select(u32(_e54), 0u, (_e54 < 0f)), 4294967295u, (_e54 > 4294967000f)), _e169), _e168), 0u, select(true, select(true, false, _e169), _e168)), bitcast<u32>(f32(_e51[0])), select((_e182 | 2147483648u), ~(_e182), ((_e182 >> bitcast<u32>(31i)) == 1u)), bitcast<u32>(bitcast<f32>(select(~(_e51[0]), (_e51[0] & 2147483647u), ((_e51[0] >> bitcast<u32>(31i)) == 1u)))), select((bitcast<u32>(31i) - firstLeadingBit(_e51[0])), 32u, (_e51[0] == 0u)), select(firstTrailingBit(_e51[0]), 32u, (_e51[0] == 0u)), countOneBits(_e51[0]), (_e51[0] * _e51[1]), ((_e51[0] << bitcast<u32>(((_e51[1] & 31u) & 31u))) ^ (_e51[0] >> bitcast<u32>(((_e51[1] & 31u) & 31u)))));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_scalars(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
