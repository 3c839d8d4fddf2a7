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

struct type_14 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_16 {
    member: array<type_14>,
}

struct type_17 {
    member: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

@group(0) @binding(1) 
var<storage> boxes: type_16;
@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(3) 
var<storage, read_write> keys: type_11;
@group(0) @binding(4) 
var<storage, read_write> order: type_11;
@group(0) @binding(2) 
var<storage> words: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_14;
    var local_2: type_14;
    var local_3: type_20;
    var local_4: type_14;
    var phi_135_: u32;
    var phi_136_: u32;
    var phi_139_: type_9;
    var phi_140_: type_9;
    var phi_163_: type_9;
    var phi_189_: u32;
    var phi_215_: u32;
    var phi_249_: type_9;
    var phi_252_: f32;
    var phi_250_: type_9;
    var phi_275_: type_9;
    var phi_305_: f32;
    var phi_253_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_315_: f32;
    var phi_356_: type_9;
    var phi_357_: type_9;
    var phi_380_: type_9;
    var phi_443_: u32;
    var phi_444_: u32;
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
    let _e62 = params.member.member.member_2[3u];
    if (_e58 < _e62) {
        let _e67 = params.member.member.member_2[2u];
        if (_e58 >= _e67) {
            phi_136_ = 2u;
        } else {
            let _e70 = params.member.member.member_2[1u];
            if (_e58 >= _e70) {
                phi_135_ = 1u;
            } else {
                phi_135_ = 0u;
            }
            let _e73 = phi_135_;
            phi_136_ = _e73;
        }
        let _e75 = phi_136_;
        local_2 = type_14(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_139_ = type_9(0u, 3u);
        loop {
            let _e77 = phi_139_;
            if (_e77.member < _e77.member_1) {
                phi_140_ = type_9((_e77.member + 1u), _e77.member_1);
                phi_163_ = type_9(1u, _e77.member);
            } else {
                phi_140_ = _e77;
                phi_163_ = type_9(0u, type_9().member_1);
            }
            let _e89 = phi_140_;
            let _e91 = phi_163_;
            let _e95 = (bitcast<i32>(_e91.member) != 0i);
            if _e95 {
                let _e97 = words.member[_e91.member_1];
                let _e98 = ~(_e97);
                if ((_e98 >> bitcast<u32>(31i)) == 1u) {
                    phi_189_ = (_e98 & 2147483647u);
                } else {
                    phi_189_ = ~(_e98);
                }
                let _e105 = phi_189_;
                local_2.member[_e91.member_1] = bitcast<f32>(_e105);
                let _e111 = words.member[(3u + _e91.member_1)];
                if ((_e111 >> bitcast<u32>(31i)) == 1u) {
                    phi_215_ = (_e111 & 2147483647u);
                } else {
                    phi_215_ = ~(_e111);
                }
                let _e118 = phi_215_;
                local_2.member_1[_e91.member_1] = bitcast<f32>(_e118);
            }
            continue;
            continuing {
                phi_139_ = _e89;
                break if !(_e95);
            }
        }
        let _e123 = local_2;
        local_4 = _e123;
        phi_249_ = type_9(0u, 3u);
        phi_252_ = 0f;
        loop {
            let _e125 = phi_249_;
            let _e127 = phi_252_;
            local_5 = _e127;
            local_6 = _e127;
            if (_e125.member < _e125.member_1) {
                phi_250_ = type_9((_e125.member + 1u), _e125.member_1);
                phi_275_ = type_9(1u, _e125.member);
            } else {
                phi_250_ = _e125;
                phi_275_ = type_9(0u, type_9().member_1);
            }
            let _e139 = phi_250_;
            let _e141 = phi_275_;
            let _e145 = (bitcast<i32>(_e141.member) != 0i);
            if _e145 {
                let _e148 = local_4.member_1[_e141.member_1];
                let _e152 = local_4.member[_e141.member_1];
                let _e154 = ((_e148 * 0.5f) - (_e152 * 0.5f));
                if (_e154 > _e127) {
                    phi_305_ = _e154;
                } else {
                    phi_305_ = _e127;
                }
                let _e157 = phi_305_;
                phi_253_ = _e157;
            } else {
                phi_253_ = f32();
            }
            let _e159 = phi_253_;
            continue;
            continuing {
                phi_249_ = _e139;
                phi_252_ = _e159;
                break if !(_e145);
            }
        }
        let _e162 = local_5;
        if (_e162 > 0.000000000000000000000000000001f) {
            let _e166 = local_6;
            phi_315_ = ((0.5f * 1024f) / _e166);
        } else {
            phi_315_ = 0f;
        }
        let _e169 = phi_315_;
        let _e171 = local_4.member;
        local_3 = type_20(_e171, _e169, (1024f - 1f));
        let _e177 = boxes.member[_e58];
        local_1 = type_14(array<f32, 3>(_e177.member[0], _e177.member[1], _e177.member[2]), array<f32, 3>(_e177.member_1[0], _e177.member_1[1], _e177.member_1[2]));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_356_ = type_9(0u, 3u);
        loop {
            let _e190 = phi_356_;
            if (_e190.member < _e190.member_1) {
                phi_357_ = type_9((_e190.member + 1u), _e190.member_1);
                phi_380_ = type_9(1u, _e190.member);
            } else {
                phi_357_ = _e190;
                phi_380_ = type_9(0u, type_9().member_1);
            }
            let _e202 = phi_357_;
            let _e204 = phi_380_;
            let _e208 = (bitcast<i32>(_e204.member) != 0i);
            if _e208 {
                let _e211 = local_1.member[_e204.member_1];
                let _e215 = local_1.member_1[_e204.member_1];
                let _e220 = local_3.member[_e204.member_1];
                let _e223 = local_3.member_1;
                let _e224 = ((((_e211 * 0.5f) + (_e215 * 0.5f)) - _e220) * _e223);
                let _e226 = local_3.member_2;
                if (_e224 >= _e226) {
                    let _e237 = local_3.member_2;
                    phi_444_ = select(select(u32(_e237), 0u, (_e237 < 0f)), 4294967295u, (_e237 > 4294967000f));
                } else {
                    if (_e224 > 0f) {
                        phi_443_ = select(select(u32(_e224), 0u, (_e224 < 0f)), 4294967295u, (_e224 > 4294967000f));
                    } else {
                        phi_443_ = 0u;
                    }
                    let _e235 = phi_443_;
                    phi_444_ = _e235;
                }
                let _e244 = phi_444_;
                local[_e204.member_1] = _e244;
            }
            continue;
            continuing {
                phi_356_ = _e202;
                break if !(_e208);
            }
        }
        let _e247 = local;
        let _e251 = (_e247[0] & 1023u);
        let _e255 = ((_e251 | (_e251 << bitcast<u32>(16i))) & 50331903u);
        let _e259 = ((_e255 | (_e255 << bitcast<u32>(8i))) & 50393103u);
        let _e263 = ((_e259 | (_e259 << bitcast<u32>(4i))) & 51130563u);
        let _e270 = (_e247[1] & 1023u);
        let _e274 = ((_e270 | (_e270 << bitcast<u32>(16i))) & 50331903u);
        let _e278 = ((_e274 | (_e274 << bitcast<u32>(8i))) & 50393103u);
        let _e282 = ((_e278 | (_e278 << bitcast<u32>(4i))) & 51130563u);
        let _e290 = (_e247[2] & 1023u);
        let _e294 = ((_e290 | (_e290 << bitcast<u32>(16i))) & 50331903u);
        let _e298 = ((_e294 | (_e294 << bitcast<u32>(8i))) & 50393103u);
        let _e302 = ((_e298 | (_e298 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e58] = ((_e75 << bitcast<u32>(30i)) | (((((_e263 | (_e263 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e282 | (_e282 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e302 | (_e302 << bitcast<u32>(2i))) & 153391689u)));
        order.member[_e58] = _e58;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn morton(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
