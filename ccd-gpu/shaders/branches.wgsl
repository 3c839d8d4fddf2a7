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

struct type_10 {
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
    member: array<vec4<u32>>,
}

@group(0) @binding(1) 
var<storage> keys: type_10;
@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(2) 
var<storage, read_write> branches_1: type_19;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_146_: u32;
    var phi_148_: u32;
    var phi_202_: u32;
    var phi_204_: u32;
    var phi_211_: u32;
    var phi_273_: u32;
    var phi_275_: u32;
    var phi_212_: u32;
    var phi_282_: bool;
    var local: u32;
    var phi_289_: u32;
    var phi_292_: u32;
    var phi_354_: u32;
    var phi_356_: u32;
    var phi_290_: u32;
    var phi_293_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_417_: u32;
    var phi_419_: u32;
    var phi_421_: u32;
    var phi_424_: u32;
    var phi_502_: u32;
    var phi_504_: u32;
    var phi_422_: u32;
    var phi_425_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = n_2;
    let _e16 = lane_2;
    let _e26 = ((((_e14.y * _e15.x) + _e14.x) * 256u) + _e16);
    let _e29 = params.member.member_2.member_1;
    let _e33 = params.member.member.member[_e29];
    if ((_e26 + 1u) < _e33) {
        let _e39 = params.member.member.member_2[_e29];
        if (1u < (_e33 - _e26)) {
            let _e42 = (_e26 + 1u);
            let _e45 = keys.member[(_e39 + _e26)];
            let _e48 = keys.member[(_e39 + _e42)];
            let _e49 = (_e45 ^ _e48);
            let _e54 = select((bitcast<u32>(31i) - firstLeadingBit(_e49)), 32u, (_e49 == 0u));
            if (_e54 < 32u) {
                phi_146_ = _e54;
            } else {
                let _e56 = (_e26 ^ _e42);
                phi_146_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e56)), 32u, (_e56 == 0u)));
            }
            let _e64 = phi_146_;
            phi_148_ = (1u + _e64);
        } else {
            phi_148_ = 0u;
        }
        let _e67 = phi_148_;
        if (1u <= _e26) {
            let _e69 = (_e26 - 1u);
            let _e72 = keys.member[(_e39 + _e26)];
            let _e75 = keys.member[(_e39 + _e69)];
            let _e76 = (_e72 ^ _e75);
            let _e81 = select((bitcast<u32>(31i) - firstLeadingBit(_e76)), 32u, (_e76 == 0u));
            if (_e81 < 32u) {
                phi_202_ = _e81;
            } else {
                let _e83 = (_e26 ^ _e69);
                phi_202_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e83)), 32u, (_e83 == 0u)));
            }
            let _e91 = phi_202_;
            phi_204_ = (1u + _e91);
        } else {
            phi_204_ = 0u;
        }
        let _e94 = phi_204_;
        let _e95 = (_e67 > _e94);
        let _e96 = select(_e67, _e94, _e95);
        phi_211_ = 2u;
        loop {
            let _e98 = phi_211_;
            local = _e98;
            if (_e98 < _e33) {
                if select((_e98 <= _e26), (_e98 < (_e33 - _e26)), _e95) {
                    let _e106 = select((_e26 - _e98), (_e26 + _e98), _e95);
                    let _e109 = keys.member[(_e39 + _e26)];
                    let _e112 = keys.member[(_e39 + _e106)];
                    let _e113 = (_e109 ^ _e112);
                    let _e118 = select((bitcast<u32>(31i) - firstLeadingBit(_e113)), 32u, (_e113 == 0u));
                    if (_e118 < 32u) {
                        phi_273_ = _e118;
                    } else {
                        let _e120 = (_e26 ^ _e106);
                        phi_273_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e120)), 32u, (_e120 == 0u)));
                    }
                    let _e128 = phi_273_;
                    phi_275_ = (1u + _e128);
                } else {
                    phi_275_ = 0u;
                }
                let _e131 = phi_275_;
                let _e132 = (_e131 > _e96);
                phi_212_ = select(u32(), (_e98 * 2u), _e132);
                phi_282_ = _e132;
            } else {
                phi_212_ = u32();
                phi_282_ = false;
            }
            let _e136 = phi_212_;
            let _e138 = phi_282_;
            continue;
            continuing {
                phi_211_ = _e136;
                break if !(_e138);
            }
        }
        let _e141 = local;
        phi_289_ = (_e141 / 2u);
        phi_292_ = 0u;
        loop {
            let _e144 = phi_289_;
            let _e146 = phi_292_;
            local_1 = _e146;
            local_2 = _e146;
            local_3 = _e146;
            local_4 = _e146;
            local_9 = _e146;
            local_5 = _e146;
            local_6 = _e146;
            let _e147 = (_e144 > 0u);
            if _e147 {
                let _e148 = (_e146 + _e144);
                if select((_e148 <= _e26), (_e148 < (_e33 - _e26)), _e95) {
                    let _e155 = select((_e26 - _e148), (_e26 + _e148), _e95);
                    let _e158 = keys.member[(_e39 + _e26)];
                    let _e161 = keys.member[(_e39 + _e155)];
                    let _e162 = (_e158 ^ _e161);
                    let _e167 = select((bitcast<u32>(31i) - firstLeadingBit(_e162)), 32u, (_e162 == 0u));
                    if (_e167 < 32u) {
                        phi_354_ = _e167;
                    } else {
                        let _e169 = (_e26 ^ _e155);
                        phi_354_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e169)), 32u, (_e169 == 0u)));
                    }
                    let _e177 = phi_354_;
                    phi_356_ = (1u + _e177);
                } else {
                    phi_356_ = 0u;
                }
                let _e180 = phi_356_;
                phi_290_ = (_e144 / 2u);
                phi_293_ = select(_e146, (_e146 + _e144), (_e180 > _e96));
            } else {
                phi_290_ = u32();
                phi_293_ = u32();
            }
            let _e186 = phi_290_;
            let _e188 = phi_293_;
            continue;
            continuing {
                phi_289_ = _e186;
                phi_292_ = _e188;
                break if !(_e147);
            }
        }
        let _e192 = local_1;
        let _e195 = local_2;
        if select((_e195 <= _e26), (_e192 < (_e33 - _e26)), _e95) {
            let _e199 = local_3;
            let _e202 = local_4;
            let _e204 = select((_e26 - _e202), (_e26 + _e199), _e95);
            let _e207 = keys.member[(_e39 + _e26)];
            let _e210 = keys.member[(_e39 + _e204)];
            let _e211 = (_e207 ^ _e210);
            let _e216 = select((bitcast<u32>(31i) - firstLeadingBit(_e211)), 32u, (_e211 == 0u));
            if (_e216 < 32u) {
                phi_417_ = _e216;
            } else {
                let _e218 = (_e26 ^ _e204);
                phi_417_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u)));
            }
            let _e226 = phi_417_;
            phi_419_ = (1u + _e226);
        } else {
            phi_419_ = 0u;
        }
        let _e229 = phi_419_;
        let _e331 = local_9;
        phi_421_ = _e331;
        phi_424_ = 0u;
        loop {
            let _e231 = phi_421_;
            let _e233 = phi_424_;
            local_7 = _e233;
            local_8 = _e233;
            let _e234 = (_e231 > 1u);
            if _e234 {
                let _e235 = (_e231 / 2u);
                let _e239 = select(_e235, (_e235 + 1u), ((_e231 % 2u) > 0u));
                let _e240 = (_e233 + _e239);
                if select((_e240 <= _e26), (_e240 < (_e33 - _e26)), _e95) {
                    let _e247 = select((_e26 - _e240), (_e26 + _e240), _e95);
                    let _e250 = keys.member[(_e39 + _e26)];
                    let _e253 = keys.member[(_e39 + _e247)];
                    let _e254 = (_e250 ^ _e253);
                    let _e259 = select((bitcast<u32>(31i) - firstLeadingBit(_e254)), 32u, (_e254 == 0u));
                    if (_e259 < 32u) {
                        phi_502_ = _e259;
                    } else {
                        let _e261 = (_e26 ^ _e247);
                        phi_502_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e261)), 32u, (_e261 == 0u)));
                    }
                    let _e269 = phi_502_;
                    phi_504_ = (1u + _e269);
                } else {
                    phi_504_ = 0u;
                }
                let _e272 = phi_504_;
                phi_422_ = _e239;
                phi_425_ = select(_e233, (_e233 + _e239), (_e272 > _e229));
            } else {
                phi_422_ = u32();
                phi_425_ = u32();
            }
            let _e277 = phi_422_;
            let _e279 = phi_425_;
            continue;
            continuing {
                phi_421_ = _e277;
                phi_424_ = _e279;
                break if !(_e234);
            }
        }
        let _e282 = local_5;
        let _e285 = local_6;
        let _e287 = select((_e26 - _e285), _e26, _e95);
        let _e288 = select(_e26, (_e26 + _e282), _e95);
        let _e290 = local_7;
        let _e294 = local_8;
        let _e296 = select((_e26 - _e294), ((_e26 + _e290) + 1u), _e95);
        let _e297 = (_e33 - 1u);
        let _e298 = (_e296 - 1u);
        branches_1.member[_e26] = vec4<u32>(select(_e298, (_e297 + _e287), (_e287 == _e298)), select(_e296, (_e297 + _e296), (_e296 == _e288)), _e287, _e288);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branches(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
