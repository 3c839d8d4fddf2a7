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
    var phi_143_: u32;
    var phi_144_: u32;
    var phi_158_: type_9;
    var phi_159_: type_9;
    var phi_182_: type_9;
    var phi_209_: u32;
    var phi_236_: u32;
    var phi_270_: type_9;
    var phi_273_: f32;
    var phi_271_: type_9;
    var phi_296_: type_9;
    var phi_326_: f32;
    var phi_274_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_336_: f32;
    var phi_388_: type_9;
    var phi_389_: type_9;
    var phi_412_: type_9;
    var phi_475_: u32;
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
            if (_e63 >= _e75) {
                phi_143_ = 1u;
            } else {
                phi_143_ = 0u;
            }
            let _e78 = phi_143_;
            phi_144_ = _e78;
        }
        let _e80 = phi_144_;
        let _e82 = worlds.member[_e63];
        let _e83 = (6u * _e82);
        local_2 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_158_ = type_9(0u, 3u);
        loop {
            let _e85 = phi_158_;
            if (_e85.member < _e85.member_1) {
                phi_159_ = type_9((_e85.member + 1u), _e85.member_1);
                phi_182_ = type_9(1u, _e85.member);
            } else {
                phi_159_ = _e85;
                phi_182_ = type_9(0u, type_9().member_1);
            }
            let _e97 = phi_159_;
            let _e99 = phi_182_;
            let _e103 = (bitcast<i32>(_e99.member) != 0i);
            if _e103 {
                let _e106 = words.member[(_e83 + _e99.member_1)];
                let _e107 = ~(_e106);
                if ((_e107 >> bitcast<u32>(31i)) == 1u) {
                    phi_209_ = (_e107 & 2147483647u);
                } else {
                    phi_209_ = ~(_e107);
                }
                let _e114 = phi_209_;
                local_2.member[_e99.member_1] = bitcast<f32>(_e114);
                let _e121 = words.member[((_e83 + 3u) + _e99.member_1)];
                if ((_e121 >> bitcast<u32>(31i)) == 1u) {
                    phi_236_ = (_e121 & 2147483647u);
                } else {
                    phi_236_ = ~(_e121);
                }
                let _e128 = phi_236_;
                local_2.member_1[_e99.member_1] = bitcast<f32>(_e128);
            }
            continue;
            continuing {
                phi_158_ = _e97;
                break if !(_e103);
            }
        }
        let _e133 = local_2;
        local_4 = _e133;
        phi_270_ = type_9(0u, 3u);
        phi_273_ = 0f;
        loop {
            let _e135 = phi_270_;
            let _e137 = phi_273_;
            local_5 = _e137;
            local_6 = _e137;
            if (_e135.member < _e135.member_1) {
                phi_271_ = type_9((_e135.member + 1u), _e135.member_1);
                phi_296_ = type_9(1u, _e135.member);
            } else {
                phi_271_ = _e135;
                phi_296_ = type_9(0u, type_9().member_1);
            }
            let _e149 = phi_271_;
            let _e151 = phi_296_;
            let _e155 = (bitcast<i32>(_e151.member) != 0i);
            if _e155 {
                let _e158 = local_4.member_1[_e151.member_1];
                let _e162 = local_4.member[_e151.member_1];
                let _e164 = ((_e158 * 0.5f) - (_e162 * 0.5f));
                if (_e164 > _e137) {
                    phi_326_ = _e164;
                } else {
                    phi_326_ = _e137;
                }
                let _e167 = phi_326_;
                phi_274_ = _e167;
            } else {
                phi_274_ = f32();
            }
            let _e169 = phi_274_;
            continue;
            continuing {
                phi_270_ = _e149;
                phi_273_ = _e169;
                break if !(_e155);
            }
        }
        let _e172 = local_5;
        if (_e172 > 0.000000000000000000000000000001f) {
            let _e176 = local_6;
            phi_336_ = ((0.5f * 1024f) / _e176);
        } else {
            phi_336_ = 0f;
        }
        let _e179 = phi_336_;
        let _e181 = local_4.member;
        local_3 = type_22(_e181, _e179, (1024f - 1f));
        let _e186 = params.member.member_2.member;
        let _e188 = boxes.member[_e63];
        local_1 = type_18(array<f32, 3>(_e188.member.x, _e188.member.y, _e188.member_1.x), array<f32, 3>(_e188.member_1.y, _e188.member_2.x, _e188.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_388_ = type_9(0u, 3u);
        loop {
            let _e205 = phi_388_;
            if (_e205.member < _e205.member_1) {
                phi_389_ = type_9((_e205.member + 1u), _e205.member_1);
                phi_412_ = type_9(1u, _e205.member);
            } else {
                phi_389_ = _e205;
                phi_412_ = type_9(0u, type_9().member_1);
            }
            let _e217 = phi_389_;
            let _e219 = phi_412_;
            let _e223 = (bitcast<i32>(_e219.member) != 0i);
            if _e223 {
                let _e226 = local_1.member[_e219.member_1];
                let _e230 = local_1.member_1[_e219.member_1];
                let _e235 = local_3.member[_e219.member_1];
                let _e238 = local_3.member_1;
                let _e239 = ((((_e226 * 0.5f) + (_e230 * 0.5f)) - _e235) * _e238);
                let _e241 = local_3.member_2;
                if (_e239 >= _e241) {
                    let _e252 = local_3.member_2;
                    phi_476_ = select(select(u32(_e252), 0u, (_e252 < 0f)), 4294967295u, (_e252 > 4294967000f));
                } else {
                    if (_e239 > 0f) {
                        phi_475_ = select(select(u32(_e239), 0u, (_e239 < 0f)), 4294967295u, (_e239 > 4294967000f));
                    } else {
                        phi_475_ = 0u;
                    }
                    let _e250 = phi_475_;
                    phi_476_ = _e250;
                }
                let _e259 = phi_476_;
                local[_e219.member_1] = _e259;
            }
            continue;
            continuing {
                phi_388_ = _e217;
                break if !(_e223);
            }
        }
        let _e262 = local;
        let _e266 = (_e262[0] & 1023u);
        let _e270 = ((_e266 | (_e266 << bitcast<u32>(16i))) & 50331903u);
        let _e274 = ((_e270 | (_e270 << bitcast<u32>(8i))) & 50393103u);
        let _e278 = ((_e274 | (_e274 << bitcast<u32>(4i))) & 51130563u);
        let _e285 = (_e262[1] & 1023u);
        let _e289 = ((_e285 | (_e285 << bitcast<u32>(16i))) & 50331903u);
        let _e293 = ((_e289 | (_e289 << bitcast<u32>(8i))) & 50393103u);
        let _e297 = ((_e293 | (_e293 << bitcast<u32>(4i))) & 51130563u);
        let _e305 = (_e262[2] & 1023u);
        let _e309 = ((_e305 | (_e305 << bitcast<u32>(16i))) & 50331903u);
        let _e313 = ((_e309 | (_e309 << bitcast<u32>(8i))) & 50393103u);
        let _e317 = ((_e313 | (_e313 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e63] = (((_e80 << bitcast<u32>(30i)) | (_e82 << bitcast<u32>(((30u - _e186) & 31u)))) | ((((((_e278 | (_e278 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e297 | (_e297 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e317 | (_e317 << bitcast<u32>(2i))) & 153391689u)) >> bitcast<u32>((_e186 & 31u))));
        order.member[_e63] = _e63;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn world_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
