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
    var phi_149_: u32;
    var phi_163_: type_9;
    var phi_275_: type_9;
    var phi_278_: f32;
    var phi_279_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_341_: f32;
    var phi_393_: type_9;
    var phi_481_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e58 = id_2;
    let _e59 = n_2;
    let _e60 = lane_2;
    let _e73 = ((((_e58.y * _e59.x) + _e58.x) * 256u) + _e60);
    let _e77 = params.member.member.member_2[3u];
    if (_e73 < _e77) {
        let _e82 = params.member.member.member_2[2u];
        if (_e73 >= _e82) {
            phi_149_ = 2u;
        } else {
            let _e85 = params.member.member.member_2[1u];
            phi_149_ = select(0u, 1u, (_e73 >= _e85));
        }
        let _e89 = phi_149_;
        let _e91 = worlds.member[_e73];
        let _e92 = (6u * _e91);
        local_2 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_163_ = type_9(0u, 3u);
        loop {
            let _e94 = phi_163_;
            let _e97 = (_e94.member < _e94.member_1);
            let _e108 = select(type_9().member_1, _e94.member, _e97);
            let _e110 = (bitcast<i32>(select(0u, 1u, _e97)) != 0i);
            if _e110 {
                let _e113 = words.member[(_e92 + _e108)];
                let _e114 = ~(_e113);
                local_2.member[_e108] = bitcast<f32>(select(~(_e114), (_e114 & 2147483647u), ((_e114 >> bitcast<u32>(31i)) == 1u)));
                let _e127 = words.member[((_e92 + 3u) + _e108)];
                local_2.member_1[_e108] = bitcast<f32>(select(~(_e127), (_e127 & 2147483647u), ((_e127 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_163_ = type_9(select(_e94.member, (_e94.member + 1u), _e97), select(_e94.member_1, _e94.member_1, _e97));
                break if !(_e110);
            }
        }
        let _e138 = local_2;
        local_4 = _e138;
        phi_275_ = type_9(0u, 3u);
        phi_278_ = 0f;
        loop {
            let _e140 = phi_275_;
            let _e142 = phi_278_;
            local_5 = _e142;
            local_6 = _e142;
            let _e145 = (_e140.member < _e140.member_1);
            let _e156 = select(type_9().member_1, _e140.member, _e145);
            let _e158 = (bitcast<i32>(select(0u, 1u, _e145)) != 0i);
            if _e158 {
                let _e161 = local_4.member_1[_e156];
                let _e165 = local_4.member[_e156];
                let _e167 = ((_e161 * 0.5f) - (_e165 * 0.5f));
                phi_279_ = select(_e142, _e167, (_e167 > _e142));
            } else {
                phi_279_ = f32();
            }
            let _e171 = phi_279_;
            continue;
            continuing {
                phi_275_ = type_9(select(_e140.member, (_e140.member + 1u), _e145), select(_e140.member_1, _e140.member_1, _e145));
                phi_278_ = _e171;
                break if !(_e158);
            }
        }
        let _e174 = local_5;
        if (_e174 > 0.000000000000000000000000000001f) {
            let _e178 = local_6;
            phi_341_ = ((0.5f * 1024f) / _e178);
        } else {
            phi_341_ = 0f;
        }
        let _e181 = phi_341_;
        let _e183 = local_4.member;
        local_3 = type_22(_e183, _e181, (1024f - 1f));
        let _e188 = params.member.member_2.member;
        let _e190 = boxes.member[_e73];
        local_1 = type_18(array<f32, 3>(_e190.member.x, _e190.member.y, _e190.member_1.x), array<f32, 3>(_e190.member_1.y, _e190.member_2.x, _e190.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_393_ = type_9(0u, 3u);
        loop {
            let _e207 = phi_393_;
            let _e210 = (_e207.member < _e207.member_1);
            let _e221 = select(type_9().member_1, _e207.member, _e210);
            let _e223 = (bitcast<i32>(select(0u, 1u, _e210)) != 0i);
            if _e223 {
                let _e226 = local_1.member[_e221];
                let _e230 = local_1.member_1[_e221];
                let _e235 = local_3.member[_e221];
                let _e238 = local_3.member_1;
                let _e239 = ((((_e226 * 0.5f) + (_e230 * 0.5f)) - _e235) * _e238);
                let _e241 = local_3.member_2;
                if (_e239 >= _e241) {
                    let _e251 = local_3.member_2;
                    phi_481_ = select(select(u32(_e251), 0u, (_e251 < 0f)), 4294967295u, (_e251 > 4294967000f));
                } else {
                    phi_481_ = select(0u, select(select(u32(_e239), 0u, (_e239 < 0f)), 4294967295u, (_e239 > 4294967000f)), (_e239 > 0f));
                }
                let _e258 = phi_481_;
                local[_e221] = _e258;
            }
            continue;
            continuing {
                phi_393_ = type_9(select(_e207.member, (_e207.member + 1u), _e210), select(_e207.member_1, _e207.member_1, _e210));
                break if !(_e223);
            }
        }
        let _e261 = local;
        let _e270 = (_e261[0] ^ (511u & (0u - ((_e261[0] >> bitcast<u32>(9u)) & 1u))));
        let _e274 = (0u - ((_e261[1] >> bitcast<u32>(9u)) & 1u));
        let _e278 = (((_e270 ^ _e261[1]) & 511u) & ~(_e274));
        let _e281 = ((_e270 ^ (511u & _e274)) ^ _e278);
        let _e282 = (_e261[1] ^ _e278);
        let _e286 = (0u - ((_e261[2] >> bitcast<u32>(9u)) & 1u));
        let _e290 = (((_e281 ^ _e261[2]) & 511u) & ~(_e286));
        let _e293 = ((_e281 ^ (511u & _e286)) ^ _e290);
        let _e294 = (_e261[2] ^ _e290);
        let _e300 = (_e293 ^ (255u & (0u - ((_e293 >> bitcast<u32>(8u)) & 1u))));
        let _e304 = (0u - ((_e282 >> bitcast<u32>(8u)) & 1u));
        let _e308 = (((_e300 ^ _e282) & 255u) & ~(_e304));
        let _e311 = ((_e300 ^ (255u & _e304)) ^ _e308);
        let _e312 = (_e282 ^ _e308);
        let _e316 = (0u - ((_e294 >> bitcast<u32>(8u)) & 1u));
        let _e320 = (((_e311 ^ _e294) & 255u) & ~(_e316));
        let _e323 = ((_e311 ^ (255u & _e316)) ^ _e320);
        let _e324 = (_e294 ^ _e320);
        let _e330 = (_e323 ^ (127u & (0u - ((_e323 >> bitcast<u32>(7u)) & 1u))));
        let _e334 = (0u - ((_e312 >> bitcast<u32>(7u)) & 1u));
        let _e338 = (((_e330 ^ _e312) & 127u) & ~(_e334));
        let _e341 = ((_e330 ^ (127u & _e334)) ^ _e338);
        let _e342 = (_e312 ^ _e338);
        let _e346 = (0u - ((_e324 >> bitcast<u32>(7u)) & 1u));
        let _e350 = (((_e341 ^ _e324) & 127u) & ~(_e346));
        let _e353 = ((_e341 ^ (127u & _e346)) ^ _e350);
        let _e354 = (_e324 ^ _e350);
        let _e360 = (_e353 ^ (63u & (0u - ((_e353 >> bitcast<u32>(6u)) & 1u))));
        let _e364 = (0u - ((_e342 >> bitcast<u32>(6u)) & 1u));
        let _e368 = (((_e360 ^ _e342) & 63u) & ~(_e364));
        let _e371 = ((_e360 ^ (63u & _e364)) ^ _e368);
        let _e372 = (_e342 ^ _e368);
        let _e376 = (0u - ((_e354 >> bitcast<u32>(6u)) & 1u));
        let _e380 = (((_e371 ^ _e354) & 63u) & ~(_e376));
        let _e383 = ((_e371 ^ (63u & _e376)) ^ _e380);
        let _e384 = (_e354 ^ _e380);
        let _e390 = (_e383 ^ (31u & (0u - ((_e383 >> bitcast<u32>(5u)) & 1u))));
        let _e394 = (0u - ((_e372 >> bitcast<u32>(5u)) & 1u));
        let _e398 = (((_e390 ^ _e372) & 31u) & ~(_e394));
        let _e401 = ((_e390 ^ (31u & _e394)) ^ _e398);
        let _e402 = (_e372 ^ _e398);
        let _e406 = (0u - ((_e384 >> bitcast<u32>(5u)) & 1u));
        let _e410 = (((_e401 ^ _e384) & 31u) & ~(_e406));
        let _e413 = ((_e401 ^ (31u & _e406)) ^ _e410);
        let _e414 = (_e384 ^ _e410);
        let _e420 = (_e413 ^ (15u & (0u - ((_e413 >> bitcast<u32>(4u)) & 1u))));
        let _e424 = (0u - ((_e402 >> bitcast<u32>(4u)) & 1u));
        let _e428 = (((_e420 ^ _e402) & 15u) & ~(_e424));
        let _e431 = ((_e420 ^ (15u & _e424)) ^ _e428);
        let _e432 = (_e402 ^ _e428);
        let _e436 = (0u - ((_e414 >> bitcast<u32>(4u)) & 1u));
        let _e440 = (((_e431 ^ _e414) & 15u) & ~(_e436));
        let _e443 = ((_e431 ^ (15u & _e436)) ^ _e440);
        let _e444 = (_e414 ^ _e440);
        let _e450 = (_e443 ^ (7u & (0u - ((_e443 >> bitcast<u32>(3u)) & 1u))));
        let _e454 = (0u - ((_e432 >> bitcast<u32>(3u)) & 1u));
        let _e458 = (((_e450 ^ _e432) & 7u) & ~(_e454));
        let _e461 = ((_e450 ^ (7u & _e454)) ^ _e458);
        let _e462 = (_e432 ^ _e458);
        let _e466 = (0u - ((_e444 >> bitcast<u32>(3u)) & 1u));
        let _e470 = (((_e461 ^ _e444) & 7u) & ~(_e466));
        let _e473 = ((_e461 ^ (7u & _e466)) ^ _e470);
        let _e474 = (_e444 ^ _e470);
        let _e480 = (_e473 ^ (3u & (0u - ((_e473 >> bitcast<u32>(2u)) & 1u))));
        let _e484 = (0u - ((_e462 >> bitcast<u32>(2u)) & 1u));
        let _e488 = (((_e480 ^ _e462) & 3u) & ~(_e484));
        let _e491 = ((_e480 ^ (3u & _e484)) ^ _e488);
        let _e492 = (_e462 ^ _e488);
        let _e496 = (0u - ((_e474 >> bitcast<u32>(2u)) & 1u));
        let _e500 = (((_e491 ^ _e474) & 3u) & ~(_e496));
        let _e503 = ((_e491 ^ (3u & _e496)) ^ _e500);
        let _e504 = (_e474 ^ _e500);
        let _e510 = (_e503 ^ (1u & (0u - ((_e503 >> bitcast<u32>(1u)) & 1u))));
        let _e514 = (0u - ((_e492 >> bitcast<u32>(1u)) & 1u));
        let _e518 = (((_e510 ^ _e492) & 1u) & ~(_e514));
        let _e521 = ((_e510 ^ (1u & _e514)) ^ _e518);
        let _e526 = (0u - ((_e504 >> bitcast<u32>(1u)) & 1u));
        let _e530 = (((_e521 ^ _e504) & 1u) & ~(_e526));
        let _e533 = ((_e521 ^ (1u & _e526)) ^ _e530);
        let _e535 = ((_e492 ^ _e518) ^ _e533);
        let _e536 = ((_e504 ^ _e530) ^ _e535);
        let _e539 = (_e536 ^ (_e536 >> bitcast<u32>(1i)));
        let _e542 = (_e539 ^ (_e539 >> bitcast<u32>(2i)));
        let _e545 = (_e542 ^ (_e542 >> bitcast<u32>(4i)));
        let _e548 = (_e545 ^ (_e545 >> bitcast<u32>(8i)));
        let _e553 = ((_e548 ^ (_e548 >> bitcast<u32>(16i))) >> bitcast<u32>(1i));
        let _e557 = ((_e533 ^ _e553) & 1023u);
        let _e561 = ((_e557 | (_e557 << bitcast<u32>(16i))) & 50331903u);
        let _e565 = ((_e561 | (_e561 << bitcast<u32>(8i))) & 50393103u);
        let _e569 = ((_e565 | (_e565 << bitcast<u32>(4i))) & 51130563u);
        let _e576 = ((_e535 ^ _e553) & 1023u);
        let _e580 = ((_e576 | (_e576 << bitcast<u32>(16i))) & 50331903u);
        let _e584 = ((_e580 | (_e580 << bitcast<u32>(8i))) & 50393103u);
        let _e588 = ((_e584 | (_e584 << bitcast<u32>(4i))) & 51130563u);
        let _e596 = ((_e536 ^ _e553) & 1023u);
        let _e600 = ((_e596 | (_e596 << bitcast<u32>(16i))) & 50331903u);
        let _e604 = ((_e600 | (_e600 << bitcast<u32>(8i))) & 50393103u);
        let _e608 = ((_e604 | (_e604 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e73] = (((_e89 << bitcast<u32>(30i)) | (_e91 << bitcast<u32>(((30u - _e188) & 31u)))) | ((((((_e569 | (_e569 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e588 | (_e588 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e608 | (_e608 << bitcast<u32>(2i))) & 153391689u)) >> bitcast<u32>((_e188 & 31u))));
        order.member[_e73] = _e73;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn world_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
