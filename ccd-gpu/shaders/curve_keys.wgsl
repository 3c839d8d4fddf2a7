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
    var phi_146_: u32;
    var phi_149_: type_9;
    var phi_259_: type_9;
    var phi_262_: f32;
    var phi_263_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_325_: f32;
    var phi_384_: type_9;
    var phi_472_: u32;
    var phi_807_: array<u32, 3>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e59 = id_2;
    let _e60 = n_2;
    let _e61 = lane_2;
    let _e73 = ((((_e59.y * _e60.x) + _e59.x) * 256u) + _e61);
    let _e77 = params.member.member.member_2[3u];
    if (_e73 < _e77) {
        let _e82 = params.member.member.member_2[2u];
        if (_e73 >= _e82) {
            phi_146_ = 2u;
        } else {
            let _e85 = params.member.member.member_2[1u];
            phi_146_ = select(0u, 1u, (_e73 >= _e85));
        }
        let _e89 = phi_146_;
        local_2 = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_149_ = type_9(0u, 3u);
        loop {
            let _e91 = phi_149_;
            let _e94 = (_e91.member < _e91.member_1);
            let _e105 = select(type_9().member_1, _e91.member, _e94);
            let _e107 = (bitcast<i32>(select(0u, 1u, _e94)) != 0i);
            if _e107 {
                let _e109 = words.member[_e105];
                let _e110 = ~(_e109);
                local_2.member[_e105] = bitcast<f32>(select(~(_e110), (_e110 & 2147483647u), ((_e110 >> bitcast<u32>(31i)) == 1u)));
                let _e122 = words.member[(3u + _e105)];
                local_2.member_1[_e105] = bitcast<f32>(select(~(_e122), (_e122 & 2147483647u), ((_e122 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_149_ = type_9(select(_e91.member, (_e91.member + 1u), _e94), select(_e91.member_1, _e91.member_1, _e94));
                break if !(_e107);
            }
        }
        let _e133 = local_2;
        local_4 = _e133;
        phi_259_ = type_9(0u, 3u);
        phi_262_ = 0f;
        loop {
            let _e135 = phi_259_;
            let _e137 = phi_262_;
            local_5 = _e137;
            local_6 = _e137;
            let _e140 = (_e135.member < _e135.member_1);
            let _e151 = select(type_9().member_1, _e135.member, _e140);
            let _e153 = (bitcast<i32>(select(0u, 1u, _e140)) != 0i);
            if _e153 {
                let _e156 = local_4.member_1[_e151];
                let _e160 = local_4.member[_e151];
                let _e162 = ((_e156 * 0.5f) - (_e160 * 0.5f));
                phi_263_ = select(_e137, _e162, (_e162 > _e137));
            } else {
                phi_263_ = f32();
            }
            let _e166 = phi_263_;
            continue;
            continuing {
                phi_259_ = type_9(select(_e135.member, (_e135.member + 1u), _e140), select(_e135.member_1, _e135.member_1, _e140));
                phi_262_ = _e166;
                break if !(_e153);
            }
        }
        let _e169 = local_5;
        if (_e169 > 0.000000000000000000000000000001f) {
            let _e173 = local_6;
            phi_325_ = ((0.5f * 1024f) / _e173);
        } else {
            phi_325_ = 0f;
        }
        let _e176 = phi_325_;
        let _e178 = local_4.member;
        local_3 = type_23(_e178, _e176, (1024f - 1f));
        let _e183 = params.member.member.member_1;
        let _e190 = boxes.member[_e73];
        local_1 = type_19(array<f32, 3>(_e190.member.x, _e190.member.y, _e190.member_1.x), array<f32, 3>(_e190.member_1.y, _e190.member_2.x, _e190.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_384_ = type_9(0u, 3u);
        loop {
            let _e207 = phi_384_;
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
                    phi_472_ = select(select(u32(_e251), 0u, (_e251 < 0f)), 4294967295u, (_e251 > 4294967000f));
                } else {
                    phi_472_ = select(0u, select(select(u32(_e239), 0u, (_e239 < 0f)), 4294967295u, (_e239 > 4294967000f)), (_e239 > 0f));
                }
                let _e258 = phi_472_;
                local[_e221] = _e258;
            }
            continue;
            continuing {
                phi_384_ = type_9(select(_e207.member, (_e207.member + 1u), _e210), select(_e207.member_1, _e207.member_1, _e210));
                break if !(_e223);
            }
        }
        let _e261 = local;
        if (select(0i, 1i, select(false, true, ((_e183 & 2048u) != 0u))) == 1i) {
            let _e273 = (_e261[0] ^ (511u & (0u - ((_e261[0] >> bitcast<u32>(9u)) & 1u))));
            let _e277 = (0u - ((_e261[1] >> bitcast<u32>(9u)) & 1u));
            let _e281 = (((_e273 ^ _e261[1]) & 511u) & ~(_e277));
            let _e284 = ((_e273 ^ (511u & _e277)) ^ _e281);
            let _e285 = (_e261[1] ^ _e281);
            let _e289 = (0u - ((_e261[2] >> bitcast<u32>(9u)) & 1u));
            let _e293 = (((_e284 ^ _e261[2]) & 511u) & ~(_e289));
            let _e296 = ((_e284 ^ (511u & _e289)) ^ _e293);
            let _e297 = (_e261[2] ^ _e293);
            let _e303 = (_e296 ^ (255u & (0u - ((_e296 >> bitcast<u32>(8u)) & 1u))));
            let _e307 = (0u - ((_e285 >> bitcast<u32>(8u)) & 1u));
            let _e311 = (((_e303 ^ _e285) & 255u) & ~(_e307));
            let _e314 = ((_e303 ^ (255u & _e307)) ^ _e311);
            let _e315 = (_e285 ^ _e311);
            let _e319 = (0u - ((_e297 >> bitcast<u32>(8u)) & 1u));
            let _e323 = (((_e314 ^ _e297) & 255u) & ~(_e319));
            let _e326 = ((_e314 ^ (255u & _e319)) ^ _e323);
            let _e327 = (_e297 ^ _e323);
            let _e333 = (_e326 ^ (127u & (0u - ((_e326 >> bitcast<u32>(7u)) & 1u))));
            let _e337 = (0u - ((_e315 >> bitcast<u32>(7u)) & 1u));
            let _e341 = (((_e333 ^ _e315) & 127u) & ~(_e337));
            let _e344 = ((_e333 ^ (127u & _e337)) ^ _e341);
            let _e345 = (_e315 ^ _e341);
            let _e349 = (0u - ((_e327 >> bitcast<u32>(7u)) & 1u));
            let _e353 = (((_e344 ^ _e327) & 127u) & ~(_e349));
            let _e356 = ((_e344 ^ (127u & _e349)) ^ _e353);
            let _e357 = (_e327 ^ _e353);
            let _e363 = (_e356 ^ (63u & (0u - ((_e356 >> bitcast<u32>(6u)) & 1u))));
            let _e367 = (0u - ((_e345 >> bitcast<u32>(6u)) & 1u));
            let _e371 = (((_e363 ^ _e345) & 63u) & ~(_e367));
            let _e374 = ((_e363 ^ (63u & _e367)) ^ _e371);
            let _e375 = (_e345 ^ _e371);
            let _e379 = (0u - ((_e357 >> bitcast<u32>(6u)) & 1u));
            let _e383 = (((_e374 ^ _e357) & 63u) & ~(_e379));
            let _e386 = ((_e374 ^ (63u & _e379)) ^ _e383);
            let _e387 = (_e357 ^ _e383);
            let _e393 = (_e386 ^ (31u & (0u - ((_e386 >> bitcast<u32>(5u)) & 1u))));
            let _e397 = (0u - ((_e375 >> bitcast<u32>(5u)) & 1u));
            let _e401 = (((_e393 ^ _e375) & 31u) & ~(_e397));
            let _e404 = ((_e393 ^ (31u & _e397)) ^ _e401);
            let _e405 = (_e375 ^ _e401);
            let _e409 = (0u - ((_e387 >> bitcast<u32>(5u)) & 1u));
            let _e413 = (((_e404 ^ _e387) & 31u) & ~(_e409));
            let _e416 = ((_e404 ^ (31u & _e409)) ^ _e413);
            let _e417 = (_e387 ^ _e413);
            let _e423 = (_e416 ^ (15u & (0u - ((_e416 >> bitcast<u32>(4u)) & 1u))));
            let _e427 = (0u - ((_e405 >> bitcast<u32>(4u)) & 1u));
            let _e431 = (((_e423 ^ _e405) & 15u) & ~(_e427));
            let _e434 = ((_e423 ^ (15u & _e427)) ^ _e431);
            let _e435 = (_e405 ^ _e431);
            let _e439 = (0u - ((_e417 >> bitcast<u32>(4u)) & 1u));
            let _e443 = (((_e434 ^ _e417) & 15u) & ~(_e439));
            let _e446 = ((_e434 ^ (15u & _e439)) ^ _e443);
            let _e447 = (_e417 ^ _e443);
            let _e453 = (_e446 ^ (7u & (0u - ((_e446 >> bitcast<u32>(3u)) & 1u))));
            let _e457 = (0u - ((_e435 >> bitcast<u32>(3u)) & 1u));
            let _e461 = (((_e453 ^ _e435) & 7u) & ~(_e457));
            let _e464 = ((_e453 ^ (7u & _e457)) ^ _e461);
            let _e465 = (_e435 ^ _e461);
            let _e469 = (0u - ((_e447 >> bitcast<u32>(3u)) & 1u));
            let _e473 = (((_e464 ^ _e447) & 7u) & ~(_e469));
            let _e476 = ((_e464 ^ (7u & _e469)) ^ _e473);
            let _e477 = (_e447 ^ _e473);
            let _e483 = (_e476 ^ (3u & (0u - ((_e476 >> bitcast<u32>(2u)) & 1u))));
            let _e487 = (0u - ((_e465 >> bitcast<u32>(2u)) & 1u));
            let _e491 = (((_e483 ^ _e465) & 3u) & ~(_e487));
            let _e494 = ((_e483 ^ (3u & _e487)) ^ _e491);
            let _e495 = (_e465 ^ _e491);
            let _e499 = (0u - ((_e477 >> bitcast<u32>(2u)) & 1u));
            let _e503 = (((_e494 ^ _e477) & 3u) & ~(_e499));
            let _e506 = ((_e494 ^ (3u & _e499)) ^ _e503);
            let _e507 = (_e477 ^ _e503);
            let _e513 = (_e506 ^ (1u & (0u - ((_e506 >> bitcast<u32>(1u)) & 1u))));
            let _e517 = (0u - ((_e495 >> bitcast<u32>(1u)) & 1u));
            let _e521 = (((_e513 ^ _e495) & 1u) & ~(_e517));
            let _e524 = ((_e513 ^ (1u & _e517)) ^ _e521);
            let _e529 = (0u - ((_e507 >> bitcast<u32>(1u)) & 1u));
            let _e533 = (((_e524 ^ _e507) & 1u) & ~(_e529));
            let _e536 = ((_e524 ^ (1u & _e529)) ^ _e533);
            let _e538 = ((_e495 ^ _e521) ^ _e536);
            let _e539 = ((_e507 ^ _e533) ^ _e538);
            let _e542 = (_e539 ^ (_e539 >> bitcast<u32>(1i)));
            let _e545 = (_e542 ^ (_e542 >> bitcast<u32>(2i)));
            let _e548 = (_e545 ^ (_e545 >> bitcast<u32>(4i)));
            let _e551 = (_e548 ^ (_e548 >> bitcast<u32>(8i)));
            let _e556 = ((_e551 ^ (_e551 >> bitcast<u32>(16i))) >> bitcast<u32>(1i));
            phi_807_ = array<u32, 3>((_e536 ^ _e556), (_e538 ^ _e556), (_e539 ^ _e556));
        } else {
            phi_807_ = array<u32, 3>(_e261[0], _e261[1], _e261[2]);
        }
        let _e562 = phi_807_;
        let _e564 = (_e562[0] & 1023u);
        let _e568 = ((_e564 | (_e564 << bitcast<u32>(16i))) & 50331903u);
        let _e572 = ((_e568 | (_e568 << bitcast<u32>(8i))) & 50393103u);
        let _e576 = ((_e572 | (_e572 << bitcast<u32>(4i))) & 51130563u);
        let _e584 = (_e562[1] & 1023u);
        let _e588 = ((_e584 | (_e584 << bitcast<u32>(16i))) & 50331903u);
        let _e592 = ((_e588 | (_e588 << bitcast<u32>(8i))) & 50393103u);
        let _e596 = ((_e592 | (_e592 << bitcast<u32>(4i))) & 51130563u);
        let _e605 = (_e562[2] & 1023u);
        let _e609 = ((_e605 | (_e605 << bitcast<u32>(16i))) & 50331903u);
        let _e613 = ((_e609 | (_e609 << bitcast<u32>(8i))) & 50393103u);
        let _e617 = ((_e613 | (_e613 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e73] = ((_e89 << bitcast<u32>(30i)) | (((((_e576 | (_e576 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e596 | (_e596 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e617 | (_e617 << bitcast<u32>(2i))) & 153391689u)));
        order.member[_e73] = _e73;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn curve_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
