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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(3) 
var<storage, read_write> keys: type_11;
@group(0) @binding(4) 
var<storage, read_write> order: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(2) 
var<storage> words: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_19;
    var local_2: type_19;
    var local_3: type_23;
    var local_4: type_19;
    var phi_142_: u32;
    var phi_145_: type_9;
    var phi_255_: type_9;
    var phi_258_: f32;
    var phi_259_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_321_: f32;
    var phi_380_: type_9;
    var phi_468_: u32;
    var phi_491_: type_9;
    var phi_494_: u32;
    var phi_496_: u32;
    var phi_498_: u32;
    var phi_495_: u32;
    var phi_497_: u32;
    var phi_499_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_580_: array<u32, 3>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e65 = ((((_e51.y * _e52.x) + _e51.x) * 256u) + _e53);
    let _e69 = params.member.member.member_2[3u];
    if (_e65 < _e69) {
        let _e74 = params.member.member.member_2[2u];
        if (_e65 >= _e74) {
            phi_142_ = 2u;
        } else {
            let _e77 = params.member.member.member_2[1u];
            phi_142_ = select(0u, 1u, (_e65 >= _e77));
        }
        let _e81 = phi_142_;
        local_2 = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_145_ = type_9(0u, 3u);
        loop {
            let _e83 = phi_145_;
            let _e86 = (_e83.member < _e83.member_1);
            let _e97 = select(type_9().member_1, _e83.member, _e86);
            let _e99 = (bitcast<i32>(select(0u, 1u, _e86)) != 0i);
            if _e99 {
                let _e101 = words.member[_e97];
                let _e102 = ~(_e101);
                local_2.member[_e97] = bitcast<f32>(select(~(_e102), (_e102 & 2147483647u), ((_e102 >> bitcast<u32>(31i)) == 1u)));
                let _e114 = words.member[(3u + _e97)];
                local_2.member_1[_e97] = bitcast<f32>(select(~(_e114), (_e114 & 2147483647u), ((_e114 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_145_ = type_9(select(_e83.member, (_e83.member + 1u), _e86), select(_e83.member_1, _e83.member_1, _e86));
                break if !(_e99);
            }
        }
        let _e125 = local_2;
        local_4 = _e125;
        phi_255_ = type_9(0u, 3u);
        phi_258_ = 0f;
        loop {
            let _e127 = phi_255_;
            let _e129 = phi_258_;
            local_5 = _e129;
            local_6 = _e129;
            let _e132 = (_e127.member < _e127.member_1);
            let _e143 = select(type_9().member_1, _e127.member, _e132);
            let _e145 = (bitcast<i32>(select(0u, 1u, _e132)) != 0i);
            if _e145 {
                let _e148 = local_4.member_1[_e143];
                let _e152 = local_4.member[_e143];
                let _e154 = ((_e148 * 0.5f) - (_e152 * 0.5f));
                phi_259_ = select(_e129, _e154, (_e154 > _e129));
            } else {
                phi_259_ = f32();
            }
            let _e158 = phi_259_;
            continue;
            continuing {
                phi_255_ = type_9(select(_e127.member, (_e127.member + 1u), _e132), select(_e127.member_1, _e127.member_1, _e132));
                phi_258_ = _e158;
                break if !(_e145);
            }
        }
        let _e161 = local_5;
        if (_e161 > 0.000000000000000000000000000001f) {
            let _e165 = local_6;
            phi_321_ = ((0.5f * 1024f) / _e165);
        } else {
            phi_321_ = 0f;
        }
        let _e168 = phi_321_;
        let _e170 = local_4.member;
        local_3 = type_23(_e170, _e168, (1024f - 1f));
        let _e175 = params.member.member.member_1;
        let _e182 = boxes.member[_e65];
        local_1 = type_19(array<f32, 3>(_e182.member.x, _e182.member.y, _e182.member_1.x), array<f32, 3>(_e182.member_1.y, _e182.member_2.x, _e182.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_380_ = type_9(0u, 3u);
        loop {
            let _e199 = phi_380_;
            let _e202 = (_e199.member < _e199.member_1);
            let _e213 = select(type_9().member_1, _e199.member, _e202);
            let _e215 = (bitcast<i32>(select(0u, 1u, _e202)) != 0i);
            if _e215 {
                let _e218 = local_1.member[_e213];
                let _e222 = local_1.member_1[_e213];
                let _e227 = local_3.member[_e213];
                let _e230 = local_3.member_1;
                let _e231 = ((((_e218 * 0.5f) + (_e222 * 0.5f)) - _e227) * _e230);
                let _e233 = local_3.member_2;
                if (_e231 >= _e233) {
                    let _e243 = local_3.member_2;
                    phi_468_ = select(select(u32(_e243), 0u, (_e243 < 0f)), 4294967295u, (_e243 > 4294967000f));
                } else {
                    phi_468_ = select(0u, select(select(u32(_e231), 0u, (_e231 < 0f)), 4294967295u, (_e231 > 4294967000f)), (_e231 > 0f));
                }
                let _e250 = phi_468_;
                local[_e213] = _e250;
            }
            continue;
            continuing {
                phi_380_ = type_9(select(_e199.member, (_e199.member + 1u), _e202), select(_e199.member_1, _e199.member_1, _e202));
                break if !(_e215);
            }
        }
        let _e253 = local;
        if (select(0i, 1i, select(false, true, ((_e175 & 2048u) != 0u))) == 1i) {
            phi_491_ = type_9(1u, 10u);
            phi_494_ = _e253[2];
            phi_496_ = _e253[0];
            phi_498_ = _e253[1];
            loop {
                let _e261 = phi_491_;
                let _e263 = phi_494_;
                let _e265 = phi_496_;
                let _e267 = phi_498_;
                local_7 = _e267;
                local_8 = _e265;
                local_9 = _e263;
                local_10 = _e265;
                let _e270 = (_e261.member < _e261.member_1);
                let _e283 = (bitcast<i32>(select(0u, 1u, _e270)) != 0i);
                if _e283 {
                    let _e284 = (10u - select(type_9().member_1, _e261.member, _e270));
                    let _e288 = ((1u << bitcast<u32>((_e284 & 31u))) - 1u);
                    let _e295 = (_e265 ^ (_e288 & (0u - ((_e265 >> bitcast<u32>((_e284 & 31u))) & 1u))));
                    let _e300 = (0u - ((_e267 >> bitcast<u32>((_e284 & 31u))) & 1u));
                    let _e304 = (((_e295 ^ _e267) & _e288) & ~(_e300));
                    let _e307 = ((_e295 ^ (_e288 & _e300)) ^ _e304);
                    let _e313 = (0u - ((_e263 >> bitcast<u32>((_e284 & 31u))) & 1u));
                    let _e317 = (((_e307 ^ _e263) & _e288) & ~(_e313));
                    phi_495_ = (_e263 ^ _e317);
                    phi_497_ = ((_e307 ^ (_e288 & _e313)) ^ _e317);
                    phi_499_ = (_e267 ^ _e304);
                } else {
                    phi_495_ = u32();
                    phi_497_ = u32();
                    phi_499_ = u32();
                }
                let _e323 = phi_495_;
                let _e325 = phi_497_;
                let _e327 = phi_499_;
                continue;
                continuing {
                    phi_491_ = type_9(select(_e261.member, (_e261.member + 1u), _e270), select(_e261.member_1, _e261.member_1, _e270));
                    phi_494_ = _e323;
                    phi_496_ = _e325;
                    phi_498_ = _e327;
                    break if !(_e283);
                }
            }
            let _e330 = local_7;
            let _e332 = local_8;
            let _e333 = (_e330 ^ _e332);
            let _e335 = local_9;
            let _e336 = (_e335 ^ _e333);
            let _e339 = (_e336 ^ (_e336 >> bitcast<u32>(1i)));
            let _e342 = (_e339 ^ (_e339 >> bitcast<u32>(2i)));
            let _e345 = (_e342 ^ (_e342 >> bitcast<u32>(4i)));
            let _e348 = (_e345 ^ (_e345 >> bitcast<u32>(8i)));
            let _e353 = ((_e348 ^ (_e348 >> bitcast<u32>(16i))) >> bitcast<u32>(1i));
            let _e355 = local_10;
            phi_580_ = array<u32, 3>((_e355 ^ _e353), (_e333 ^ _e353), (_e336 ^ _e353));
        } else {
            phi_580_ = array<u32, 3>(_e253[0], _e253[1], _e253[2]);
        }
        let _e361 = phi_580_;
        let _e363 = (_e361[0] & 1023u);
        let _e367 = ((_e363 | (_e363 << bitcast<u32>(16i))) & 50331903u);
        let _e371 = ((_e367 | (_e367 << bitcast<u32>(8i))) & 50393103u);
        let _e375 = ((_e371 | (_e371 << bitcast<u32>(4i))) & 51130563u);
        let _e383 = (_e361[1] & 1023u);
        let _e387 = ((_e383 | (_e383 << bitcast<u32>(16i))) & 50331903u);
        let _e391 = ((_e387 | (_e387 << bitcast<u32>(8i))) & 50393103u);
        let _e395 = ((_e391 | (_e391 << bitcast<u32>(4i))) & 51130563u);
        let _e404 = (_e361[2] & 1023u);
        let _e408 = ((_e404 | (_e404 << bitcast<u32>(16i))) & 50331903u);
        let _e412 = ((_e408 | (_e408 << bitcast<u32>(8i))) & 50393103u);
        let _e416 = ((_e412 | (_e412 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e65] = ((_e81 << bitcast<u32>(30i)) | (((((_e375 | (_e375 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e395 | (_e395 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e416 | (_e416 << bitcast<u32>(2i))) & 153391689u)));
        order.member[_e65] = _e65;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn curve_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
