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

@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> boxes: type_16;
@group(0) @binding(3) 
var<storage> words: type_11;
@group(0) @binding(4) 
var<storage, read_write> keys: type_11;
@group(0) @binding(5) 
var<storage, read_write> order: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_18;
    var local_2: type_18;
    var local_3: type_22;
    var local_4: type_18;
    var phi_144_: u32;
    var phi_158_: type_9;
    var phi_270_: type_9;
    var phi_273_: f32;
    var phi_274_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_336_: f32;
    var phi_388_: type_9;
    var phi_476_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e48 = id_2;
    let _e49 = n_2;
    let _e50 = lane_2;
    let _e63 = ((((_e48.y * _e49.x) + _e48.x) * 256u) + _e50);
    let _e67 = params.member.member.member_2[3u];
    if (_e63 < _e67) {
        let _e72 = params.member.member.member_2[2u];
        if (_e63 >= _e72) {
            phi_144_ = 2u;
        } else {
            let _e75 = params.member.member.member_2[1u];
            phi_144_ = select(0u, 1u, (_e63 >= _e75));
        }
        let _e79 = phi_144_;
        let _e81 = worlds.member[_e63];
        let _e82 = (6u * _e81);
        local_2 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_158_ = type_9(0u, 3u);
        loop {
            let _e84 = phi_158_;
            let _e87 = (_e84.member < _e84.member_1);
            let _e98 = select(type_9().member_1, _e84.member, _e87);
            let _e100 = (bitcast<i32>(select(0u, 1u, _e87)) != 0i);
            if _e100 {
                let _e103 = words.member[(_e82 + _e98)];
                let _e104 = ~(_e103);
                local_2.member[_e98] = bitcast<f32>(select(~(_e104), (_e104 & 2147483647u), ((_e104 >> bitcast<u32>(31i)) == 1u)));
                let _e117 = words.member[((_e82 + 3u) + _e98)];
                local_2.member_1[_e98] = bitcast<f32>(select(~(_e117), (_e117 & 2147483647u), ((_e117 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_158_ = type_9(select(_e84.member, (_e84.member + 1u), _e87), select(_e84.member_1, _e84.member_1, _e87));
                break if !(_e100);
            }
        }
        let _e128 = local_2;
        local_4 = _e128;
        phi_270_ = type_9(0u, 3u);
        phi_273_ = 0f;
        loop {
            let _e130 = phi_270_;
            let _e132 = phi_273_;
            local_5 = _e132;
            local_6 = _e132;
            let _e135 = (_e130.member < _e130.member_1);
            let _e146 = select(type_9().member_1, _e130.member, _e135);
            let _e148 = (bitcast<i32>(select(0u, 1u, _e135)) != 0i);
            if _e148 {
                let _e151 = local_4.member_1[_e146];
                let _e155 = local_4.member[_e146];
                let _e157 = ((_e151 * 0.5f) - (_e155 * 0.5f));
                phi_274_ = select(_e132, _e157, (_e157 > _e132));
            } else {
                phi_274_ = f32();
            }
            let _e161 = phi_274_;
            continue;
            continuing {
                phi_270_ = type_9(select(_e130.member, (_e130.member + 1u), _e135), select(_e130.member_1, _e130.member_1, _e135));
                phi_273_ = _e161;
                break if !(_e148);
            }
        }
        let _e164 = local_5;
        if (_e164 > 0.000000000000000000000000000001f) {
            let _e168 = local_6;
            phi_336_ = ((0.5f * 1024f) / _e168);
        } else {
            phi_336_ = 0f;
        }
        let _e171 = phi_336_;
        let _e173 = local_4.member;
        local_3 = type_22(_e173, _e171, (1024f - 1f));
        let _e178 = params.member.member_2.member;
        let _e180 = boxes.member[_e63];
        local_1 = type_18(array<f32, 3>(_e180.member.x, _e180.member.y, _e180.member_1.x), array<f32, 3>(_e180.member_1.y, _e180.member_2.x, _e180.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_388_ = type_9(0u, 3u);
        loop {
            let _e197 = phi_388_;
            let _e200 = (_e197.member < _e197.member_1);
            let _e211 = select(type_9().member_1, _e197.member, _e200);
            let _e213 = (bitcast<i32>(select(0u, 1u, _e200)) != 0i);
            if _e213 {
                let _e216 = local_1.member[_e211];
                let _e220 = local_1.member_1[_e211];
                let _e225 = local_3.member[_e211];
                let _e228 = local_3.member_1;
                let _e229 = ((((_e216 * 0.5f) + (_e220 * 0.5f)) - _e225) * _e228);
                let _e231 = local_3.member_2;
                if (_e229 >= _e231) {
                    let _e241 = local_3.member_2;
                    phi_476_ = select(select(u32(_e241), 0u, (_e241 < 0f)), 4294967295u, (_e241 > 4294967000f));
                } else {
                    phi_476_ = select(0u, select(select(u32(_e229), 0u, (_e229 < 0f)), 4294967295u, (_e229 > 4294967000f)), (_e229 > 0f));
                }
                let _e248 = phi_476_;
                local[_e211] = _e248;
            }
            continue;
            continuing {
                phi_388_ = type_9(select(_e197.member, (_e197.member + 1u), _e200), select(_e197.member_1, _e197.member_1, _e200));
                break if !(_e213);
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
        keys.member[_e63] = (((_e79 << bitcast<u32>(30i)) | (_e81 << bitcast<u32>(((30u - _e178) & 31u)))) | ((((((_e267 | (_e267 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e286 | (_e286 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e306 | (_e306 << bitcast<u32>(2i))) & 153391689u)) >> bitcast<u32>((_e178 & 31u))));
        order.member[_e63] = _e63;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn world_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
