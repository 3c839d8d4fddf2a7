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

struct type_14 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_16 {
    member: array<type_14>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(3) 
var<storage, read_write> keys: type_11;
@group(0) @binding(4) 
var<storage, read_write> order: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_16;
@group(0) @binding(2) 
var<storage> words: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_18;
    var local_2: type_18;
    var local_3: type_22;
    var local_4: type_18;
    var phi_137_: u32;
    var phi_138_: u32;
    var phi_141_: type_9;
    var phi_142_: type_9;
    var phi_165_: type_9;
    var phi_191_: u32;
    var phi_217_: u32;
    var phi_251_: type_9;
    var phi_254_: f32;
    var phi_252_: type_9;
    var phi_277_: type_9;
    var phi_307_: f32;
    var phi_255_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_317_: f32;
    var phi_367_: type_9;
    var phi_368_: type_9;
    var phi_391_: type_9;
    var phi_454_: u32;
    var phi_455_: u32;
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
            phi_138_ = 2u;
        } else {
            let _e70 = params.member.member.member_2[1u];
            if (_e58 >= _e70) {
                phi_137_ = 1u;
            } else {
                phi_137_ = 0u;
            }
            let _e73 = phi_137_;
            phi_138_ = _e73;
        }
        let _e75 = phi_138_;
        local_2 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_141_ = type_9(0u, 3u);
        loop {
            let _e77 = phi_141_;
            if (_e77.member < _e77.member_1) {
                phi_142_ = type_9((_e77.member + 1u), _e77.member_1);
                phi_165_ = type_9(1u, _e77.member);
            } else {
                phi_142_ = _e77;
                phi_165_ = type_9(0u, type_9().member_1);
            }
            let _e89 = phi_142_;
            let _e91 = phi_165_;
            let _e95 = (bitcast<i32>(_e91.member) != 0i);
            if _e95 {
                let _e97 = words.member[_e91.member_1];
                let _e98 = ~(_e97);
                if ((_e98 >> bitcast<u32>(31i)) == 1u) {
                    phi_191_ = (_e98 & 2147483647u);
                } else {
                    phi_191_ = ~(_e98);
                }
                let _e105 = phi_191_;
                local_2.member[_e91.member_1] = bitcast<f32>(_e105);
                let _e111 = words.member[(3u + _e91.member_1)];
                if ((_e111 >> bitcast<u32>(31i)) == 1u) {
                    phi_217_ = (_e111 & 2147483647u);
                } else {
                    phi_217_ = ~(_e111);
                }
                let _e118 = phi_217_;
                local_2.member_1[_e91.member_1] = bitcast<f32>(_e118);
            }
            continue;
            continuing {
                phi_141_ = _e89;
                break if !(_e95);
            }
        }
        let _e123 = local_2;
        local_4 = _e123;
        phi_251_ = type_9(0u, 3u);
        phi_254_ = 0f;
        loop {
            let _e125 = phi_251_;
            let _e127 = phi_254_;
            local_5 = _e127;
            local_6 = _e127;
            if (_e125.member < _e125.member_1) {
                phi_252_ = type_9((_e125.member + 1u), _e125.member_1);
                phi_277_ = type_9(1u, _e125.member);
            } else {
                phi_252_ = _e125;
                phi_277_ = type_9(0u, type_9().member_1);
            }
            let _e139 = phi_252_;
            let _e141 = phi_277_;
            let _e145 = (bitcast<i32>(_e141.member) != 0i);
            if _e145 {
                let _e148 = local_4.member_1[_e141.member_1];
                let _e152 = local_4.member[_e141.member_1];
                let _e154 = ((_e148 * 0.5f) - (_e152 * 0.5f));
                if (_e154 > _e127) {
                    phi_307_ = _e154;
                } else {
                    phi_307_ = _e127;
                }
                let _e157 = phi_307_;
                phi_255_ = _e157;
            } else {
                phi_255_ = f32();
            }
            let _e159 = phi_255_;
            continue;
            continuing {
                phi_251_ = _e139;
                phi_254_ = _e159;
                break if !(_e145);
            }
        }
        let _e162 = local_5;
        if (_e162 > 0.000000000000000000000000000001f) {
            let _e166 = local_6;
            phi_317_ = ((0.5f * 1024f) / _e166);
        } else {
            phi_317_ = 0f;
        }
        let _e169 = phi_317_;
        let _e171 = local_4.member;
        local_3 = type_22(_e171, _e169, (1024f - 1f));
        let _e177 = boxes.member[_e58];
        local_1 = type_18(array<f32, 3>(_e177.member.x, _e177.member.y, _e177.member_1.x), array<f32, 3>(_e177.member_1.y, _e177.member_2.x, _e177.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_367_ = type_9(0u, 3u);
        loop {
            let _e194 = phi_367_;
            if (_e194.member < _e194.member_1) {
                phi_368_ = type_9((_e194.member + 1u), _e194.member_1);
                phi_391_ = type_9(1u, _e194.member);
            } else {
                phi_368_ = _e194;
                phi_391_ = type_9(0u, type_9().member_1);
            }
            let _e206 = phi_368_;
            let _e208 = phi_391_;
            let _e212 = (bitcast<i32>(_e208.member) != 0i);
            if _e212 {
                let _e215 = local_1.member[_e208.member_1];
                let _e219 = local_1.member_1[_e208.member_1];
                let _e224 = local_3.member[_e208.member_1];
                let _e227 = local_3.member_1;
                let _e228 = ((((_e215 * 0.5f) + (_e219 * 0.5f)) - _e224) * _e227);
                let _e230 = local_3.member_2;
                if (_e228 >= _e230) {
                    let _e241 = local_3.member_2;
                    phi_455_ = select(select(u32(_e241), 0u, (_e241 < 0f)), 4294967295u, (_e241 > 4294967000f));
                } else {
                    if (_e228 > 0f) {
                        phi_454_ = select(select(u32(_e228), 0u, (_e228 < 0f)), 4294967295u, (_e228 > 4294967000f));
                    } else {
                        phi_454_ = 0u;
                    }
                    let _e239 = phi_454_;
                    phi_455_ = _e239;
                }
                let _e248 = phi_455_;
                local[_e208.member_1] = _e248;
            }
            continue;
            continuing {
                phi_367_ = _e206;
                break if !(_e212);
            }
        }
        let _e251 = local;
        let _e255 = (_e251[0] & 1023u);
        let _e259 = ((_e255 | (_e255 << bitcast<u32>(16i))) & 50331903u);
        let _e263 = ((_e259 | (_e259 << bitcast<u32>(8i))) & 50393103u);
        let _e267 = ((_e263 | (_e263 << bitcast<u32>(4i))) & 51130563u);
        let _e274 = (_e251[1] & 1023u);
        let _e278 = ((_e274 | (_e274 << bitcast<u32>(16i))) & 50331903u);
        let _e282 = ((_e278 | (_e278 << bitcast<u32>(8i))) & 50393103u);
        let _e286 = ((_e282 | (_e282 << bitcast<u32>(4i))) & 51130563u);
        let _e294 = (_e251[2] & 1023u);
        let _e298 = ((_e294 | (_e294 << bitcast<u32>(16i))) & 50331903u);
        let _e302 = ((_e298 | (_e298 << bitcast<u32>(8i))) & 50393103u);
        let _e306 = ((_e302 | (_e302 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e58] = ((_e75 << bitcast<u32>(30i)) | (((((_e267 | (_e267 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e286 | (_e286 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e306 | (_e306 << bitcast<u32>(2i))) & 153391689u)));
        order.member[_e58] = _e58;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn morton(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
