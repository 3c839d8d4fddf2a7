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
    var phi_146_: u32;
    var phi_160_: type_9;
    var phi_272_: type_9;
    var phi_275_: f32;
    var phi_276_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_338_: f32;
    var phi_390_: type_9;
    var phi_478_: u32;
    var phi_501_: type_9;
    var phi_504_: u32;
    var phi_506_: u32;
    var phi_508_: u32;
    var phi_505_: u32;
    var phi_507_: u32;
    var phi_509_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e66 = ((((_e51.y * _e52.x) + _e51.x) * 256u) + _e53);
    let _e70 = params.member.member.member_2[3u];
    if (_e66 < _e70) {
        let _e75 = params.member.member.member_2[2u];
        if (_e66 >= _e75) {
            phi_146_ = 2u;
        } else {
            let _e78 = params.member.member.member_2[1u];
            phi_146_ = select(0u, 1u, (_e66 >= _e78));
        }
        let _e82 = phi_146_;
        let _e84 = worlds.member[_e66];
        let _e85 = (6u * _e84);
        local_2 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_160_ = type_9(0u, 3u);
        loop {
            let _e87 = phi_160_;
            let _e90 = (_e87.member < _e87.member_1);
            let _e101 = select(type_9().member_1, _e87.member, _e90);
            let _e103 = (bitcast<i32>(select(0u, 1u, _e90)) != 0i);
            if _e103 {
                let _e106 = words.member[(_e85 + _e101)];
                let _e107 = ~(_e106);
                local_2.member[_e101] = bitcast<f32>(select(~(_e107), (_e107 & 2147483647u), ((_e107 >> bitcast<u32>(31i)) == 1u)));
                let _e120 = words.member[((_e85 + 3u) + _e101)];
                local_2.member_1[_e101] = bitcast<f32>(select(~(_e120), (_e120 & 2147483647u), ((_e120 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_160_ = type_9(select(_e87.member, (_e87.member + 1u), _e90), select(_e87.member_1, _e87.member_1, _e90));
                break if !(_e103);
            }
        }
        let _e131 = local_2;
        local_4 = _e131;
        phi_272_ = type_9(0u, 3u);
        phi_275_ = 0f;
        loop {
            let _e133 = phi_272_;
            let _e135 = phi_275_;
            local_5 = _e135;
            local_6 = _e135;
            let _e138 = (_e133.member < _e133.member_1);
            let _e149 = select(type_9().member_1, _e133.member, _e138);
            let _e151 = (bitcast<i32>(select(0u, 1u, _e138)) != 0i);
            if _e151 {
                let _e154 = local_4.member_1[_e149];
                let _e158 = local_4.member[_e149];
                let _e160 = ((_e154 * 0.5f) - (_e158 * 0.5f));
                phi_276_ = select(_e135, _e160, (_e160 > _e135));
            } else {
                phi_276_ = f32();
            }
            let _e164 = phi_276_;
            continue;
            continuing {
                phi_272_ = type_9(select(_e133.member, (_e133.member + 1u), _e138), select(_e133.member_1, _e133.member_1, _e138));
                phi_275_ = _e164;
                break if !(_e151);
            }
        }
        let _e167 = local_5;
        if (_e167 > 0.000000000000000000000000000001f) {
            let _e171 = local_6;
            phi_338_ = ((0.5f * 1024f) / _e171);
        } else {
            phi_338_ = 0f;
        }
        let _e174 = phi_338_;
        let _e176 = local_4.member;
        local_3 = type_22(_e176, _e174, (1024f - 1f));
        let _e181 = params.member.member_2.member;
        let _e183 = boxes.member[_e66];
        local_1 = type_18(array<f32, 3>(_e183.member.x, _e183.member.y, _e183.member_1.x), array<f32, 3>(_e183.member_1.y, _e183.member_2.x, _e183.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_390_ = type_9(0u, 3u);
        loop {
            let _e200 = phi_390_;
            let _e203 = (_e200.member < _e200.member_1);
            let _e214 = select(type_9().member_1, _e200.member, _e203);
            let _e216 = (bitcast<i32>(select(0u, 1u, _e203)) != 0i);
            if _e216 {
                let _e219 = local_1.member[_e214];
                let _e223 = local_1.member_1[_e214];
                let _e228 = local_3.member[_e214];
                let _e231 = local_3.member_1;
                let _e232 = ((((_e219 * 0.5f) + (_e223 * 0.5f)) - _e228) * _e231);
                let _e234 = local_3.member_2;
                if (_e232 >= _e234) {
                    let _e244 = local_3.member_2;
                    phi_478_ = select(select(u32(_e244), 0u, (_e244 < 0f)), 4294967295u, (_e244 > 4294967000f));
                } else {
                    phi_478_ = select(0u, select(select(u32(_e232), 0u, (_e232 < 0f)), 4294967295u, (_e232 > 4294967000f)), (_e232 > 0f));
                }
                let _e251 = phi_478_;
                local[_e214] = _e251;
            }
            continue;
            continuing {
                phi_390_ = type_9(select(_e200.member, (_e200.member + 1u), _e203), select(_e200.member_1, _e200.member_1, _e203));
                break if !(_e216);
            }
        }
        let _e254 = local;
        phi_501_ = type_9(1u, 10u);
        phi_504_ = _e254[2];
        phi_506_ = _e254[0];
        phi_508_ = _e254[1];
        loop {
            let _e259 = phi_501_;
            let _e261 = phi_504_;
            let _e263 = phi_506_;
            let _e265 = phi_508_;
            local_7 = _e265;
            local_8 = _e263;
            local_9 = _e261;
            local_10 = _e263;
            let _e268 = (_e259.member < _e259.member_1);
            let _e281 = (bitcast<i32>(select(0u, 1u, _e268)) != 0i);
            if _e281 {
                let _e282 = (10u - select(type_9().member_1, _e259.member, _e268));
                let _e286 = ((1u << bitcast<u32>((_e282 & 31u))) - 1u);
                let _e293 = (_e263 ^ (_e286 & (0u - ((_e263 >> bitcast<u32>((_e282 & 31u))) & 1u))));
                let _e298 = (0u - ((_e265 >> bitcast<u32>((_e282 & 31u))) & 1u));
                let _e302 = (((_e293 ^ _e265) & _e286) & ~(_e298));
                let _e305 = ((_e293 ^ (_e286 & _e298)) ^ _e302);
                let _e311 = (0u - ((_e261 >> bitcast<u32>((_e282 & 31u))) & 1u));
                let _e315 = (((_e305 ^ _e261) & _e286) & ~(_e311));
                phi_505_ = (_e261 ^ _e315);
                phi_507_ = ((_e305 ^ (_e286 & _e311)) ^ _e315);
                phi_509_ = (_e265 ^ _e302);
            } else {
                phi_505_ = u32();
                phi_507_ = u32();
                phi_509_ = u32();
            }
            let _e321 = phi_505_;
            let _e323 = phi_507_;
            let _e325 = phi_509_;
            continue;
            continuing {
                phi_501_ = type_9(select(_e259.member, (_e259.member + 1u), _e268), select(_e259.member_1, _e259.member_1, _e268));
                phi_504_ = _e321;
                phi_506_ = _e323;
                phi_508_ = _e325;
                break if !(_e281);
            }
        }
        let _e328 = local_7;
        let _e330 = local_8;
        let _e331 = (_e328 ^ _e330);
        let _e333 = local_9;
        let _e334 = (_e333 ^ _e331);
        let _e337 = (_e334 ^ (_e334 >> bitcast<u32>(1i)));
        let _e340 = (_e337 ^ (_e337 >> bitcast<u32>(2i)));
        let _e343 = (_e340 ^ (_e340 >> bitcast<u32>(4i)));
        let _e346 = (_e343 ^ (_e343 >> bitcast<u32>(8i)));
        let _e351 = ((_e346 ^ (_e346 >> bitcast<u32>(16i))) >> bitcast<u32>(1i));
        let _e353 = local_10;
        let _e357 = ((_e353 ^ _e351) & 1023u);
        let _e361 = ((_e357 | (_e357 << bitcast<u32>(16i))) & 50331903u);
        let _e365 = ((_e361 | (_e361 << bitcast<u32>(8i))) & 50393103u);
        let _e369 = ((_e365 | (_e365 << bitcast<u32>(4i))) & 51130563u);
        let _e376 = ((_e331 ^ _e351) & 1023u);
        let _e380 = ((_e376 | (_e376 << bitcast<u32>(16i))) & 50331903u);
        let _e384 = ((_e380 | (_e380 << bitcast<u32>(8i))) & 50393103u);
        let _e388 = ((_e384 | (_e384 << bitcast<u32>(4i))) & 51130563u);
        let _e396 = ((_e334 ^ _e351) & 1023u);
        let _e400 = ((_e396 | (_e396 << bitcast<u32>(16i))) & 50331903u);
        let _e404 = ((_e400 | (_e400 << bitcast<u32>(8i))) & 50393103u);
        let _e408 = ((_e404 | (_e404 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e66] = (((_e82 << bitcast<u32>(30i)) | (_e84 << bitcast<u32>(((30u - _e181) & 31u)))) | ((((((_e369 | (_e369 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e388 | (_e388 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e408 | (_e408 << bitcast<u32>(2i))) & 153391689u)) >> bitcast<u32>((_e181 & 31u))));
        order.member[_e66] = _e66;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn world_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
