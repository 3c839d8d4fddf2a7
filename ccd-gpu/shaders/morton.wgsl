struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: array<u32>,
}

struct type_17 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> boxes: type_13;
@group(0) @binding(2) 
var<storage> words: type_15;
@group(0) @binding(3) 
var<storage, read_write> keys: type_15;
@group(0) @binding(4) 
var<storage, read_write> order: type_15;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_11;
    var local_2: type_11;
    var local_3: type_18;
    var local_4: type_11;
    var phi_134_: u32;
    var phi_135_: u32;
    var phi_138_: type_17;
    var phi_139_: type_17;
    var phi_162_: type_17;
    var phi_188_: u32;
    var phi_214_: u32;
    var phi_248_: type_17;
    var phi_251_: f32;
    var phi_249_: type_17;
    var phi_274_: type_17;
    var phi_304_: f32;
    var phi_252_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_314_: f32;
    var phi_355_: type_17;
    var phi_356_: type_17;
    var phi_379_: type_17;
    var phi_442_: u32;
    var phi_443_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e58 = ((((_e44.y * _e45.x) + _e44.x) * 256u) + _e46);
    let _e61 = params.member.member_2[3u];
    if (_e58 < _e61) {
        let _e65 = params.member.member_2[2u];
        if (_e58 >= _e65) {
            phi_135_ = 2u;
        } else {
            let _e68 = params.member.member_2[1u];
            if (_e58 >= _e68) {
                phi_134_ = 1u;
            } else {
                phi_134_ = 0u;
            }
            let _e71 = phi_134_;
            phi_135_ = _e71;
        }
        let _e73 = phi_135_;
        local_2 = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_138_ = type_17(0u, 3u);
        loop {
            let _e75 = phi_138_;
            if (_e75.member < _e75.member_1) {
                phi_139_ = type_17((_e75.member + 1u), _e75.member_1);
                phi_162_ = type_17(1u, _e75.member);
            } else {
                phi_139_ = _e75;
                phi_162_ = type_17(0u, type_17().member_1);
            }
            let _e87 = phi_139_;
            let _e89 = phi_162_;
            let _e93 = (bitcast<i32>(_e89.member) != 0i);
            if _e93 {
                let _e95 = words.member[_e89.member_1];
                let _e96 = ~(_e95);
                if ((_e96 >> bitcast<u32>(31i)) == 1u) {
                    phi_188_ = (_e96 & 2147483647u);
                } else {
                    phi_188_ = ~(_e96);
                }
                let _e103 = phi_188_;
                local_2.member[_e89.member_1] = bitcast<f32>(_e103);
                let _e109 = words.member[(3u + _e89.member_1)];
                if ((_e109 >> bitcast<u32>(31i)) == 1u) {
                    phi_214_ = (_e109 & 2147483647u);
                } else {
                    phi_214_ = ~(_e109);
                }
                let _e116 = phi_214_;
                local_2.member_1[_e89.member_1] = bitcast<f32>(_e116);
            }
            continue;
            continuing {
                phi_138_ = _e87;
                break if !(_e93);
            }
        }
        let _e121 = local_2;
        local_4 = _e121;
        phi_248_ = type_17(0u, 3u);
        phi_251_ = 0f;
        loop {
            let _e123 = phi_248_;
            let _e125 = phi_251_;
            local_5 = _e125;
            local_6 = _e125;
            if (_e123.member < _e123.member_1) {
                phi_249_ = type_17((_e123.member + 1u), _e123.member_1);
                phi_274_ = type_17(1u, _e123.member);
            } else {
                phi_249_ = _e123;
                phi_274_ = type_17(0u, type_17().member_1);
            }
            let _e137 = phi_249_;
            let _e139 = phi_274_;
            let _e143 = (bitcast<i32>(_e139.member) != 0i);
            if _e143 {
                let _e146 = local_4.member_1[_e139.member_1];
                let _e150 = local_4.member[_e139.member_1];
                let _e152 = ((_e146 * 0.5f) - (_e150 * 0.5f));
                if (_e152 > _e125) {
                    phi_304_ = _e152;
                } else {
                    phi_304_ = _e125;
                }
                let _e155 = phi_304_;
                phi_252_ = _e155;
            } else {
                phi_252_ = f32();
            }
            let _e157 = phi_252_;
            continue;
            continuing {
                phi_248_ = _e137;
                phi_251_ = _e157;
                break if !(_e143);
            }
        }
        let _e160 = local_5;
        if (_e160 > 0.000000000000000000000000000001f) {
            let _e164 = local_6;
            phi_314_ = ((0.5f * 1024f) / _e164);
        } else {
            phi_314_ = 0f;
        }
        let _e167 = phi_314_;
        let _e169 = local_4.member;
        local_3 = type_18(_e169, _e167, (1024f - 1f));
        let _e175 = boxes.member[_e58];
        local_1 = type_11(array<f32, 3>(_e175.member[0], _e175.member[1], _e175.member[2]), array<f32, 3>(_e175.member_1[0], _e175.member_1[1], _e175.member_1[2]));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_355_ = type_17(0u, 3u);
        loop {
            let _e188 = phi_355_;
            if (_e188.member < _e188.member_1) {
                phi_356_ = type_17((_e188.member + 1u), _e188.member_1);
                phi_379_ = type_17(1u, _e188.member);
            } else {
                phi_356_ = _e188;
                phi_379_ = type_17(0u, type_17().member_1);
            }
            let _e200 = phi_356_;
            let _e202 = phi_379_;
            let _e206 = (bitcast<i32>(_e202.member) != 0i);
            if _e206 {
                let _e209 = local_1.member[_e202.member_1];
                let _e213 = local_1.member_1[_e202.member_1];
                let _e218 = local_3.member[_e202.member_1];
                let _e221 = local_3.member_1;
                let _e222 = ((((_e209 * 0.5f) + (_e213 * 0.5f)) - _e218) * _e221);
                let _e224 = local_3.member_2;
                if (_e222 >= _e224) {
                    let _e235 = local_3.member_2;
                    phi_443_ = select(select(u32(_e235), 0u, (_e235 < 0f)), 4294967295u, (_e235 > 4294967000f));
                } else {
                    if (_e222 > 0f) {
                        phi_442_ = select(select(u32(_e222), 0u, (_e222 < 0f)), 4294967295u, (_e222 > 4294967000f));
                    } else {
                        phi_442_ = 0u;
                    }
                    let _e233 = phi_442_;
                    phi_443_ = _e233;
                }
                let _e242 = phi_443_;
                local[_e202.member_1] = _e242;
            }
            continue;
            continuing {
                phi_355_ = _e200;
                break if !(_e206);
            }
        }
        let _e245 = local;
        let _e249 = (_e245[0] & 1023u);
        let _e253 = ((_e249 | (_e249 << bitcast<u32>(16i))) & 50331903u);
        let _e257 = ((_e253 | (_e253 << bitcast<u32>(8i))) & 50393103u);
        let _e261 = ((_e257 | (_e257 << bitcast<u32>(4i))) & 51130563u);
        let _e268 = (_e245[1] & 1023u);
        let _e272 = ((_e268 | (_e268 << bitcast<u32>(16i))) & 50331903u);
        let _e276 = ((_e272 | (_e272 << bitcast<u32>(8i))) & 50393103u);
        let _e280 = ((_e276 | (_e276 << bitcast<u32>(4i))) & 51130563u);
        let _e288 = (_e245[2] & 1023u);
        let _e292 = ((_e288 | (_e288 << bitcast<u32>(16i))) & 50331903u);
        let _e296 = ((_e292 | (_e292 << bitcast<u32>(8i))) & 50393103u);
        let _e300 = ((_e296 | (_e296 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e58] = ((_e73 << bitcast<u32>(30i)) | (((((_e261 | (_e261 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e280 | (_e280 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e300 | (_e300 << bitcast<u32>(2i))) & 153391689u)));
        order.member[_e58] = _e58;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn morton(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
