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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_17 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> keys: type_13;
@group(0) @binding(2) 
var<storage, read_write> table: type_17;
var<workgroup> counts: array<atomic<u32>, 1024>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_79_: type_9;
    var phi_122_: u32;
    var phi_164_: u32;
    var phi_180_: u32;
    var phi_196_: u32;
    var phi_212_: u32;
    var phi_228_: u32;
    var phi_244_: u32;
    var phi_260_: u32;
    var phi_276_: u32;
    var phi_284_: type_9;
    var phi_331_: type_9;
    var phi_378_: type_9;
    var phi_425_: type_9;
    var phi_472_: type_9;
    var phi_519_: type_9;
    var phi_566_: type_9;
    var phi_613_: type_9;
    var phi_123_: u32;
    var phi_656_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e25 = id_2;
    let _e26 = n_2;
    let _e27 = lane_2;
    phi_79_ = type_9(0u, 4u);
    loop {
        let _e40 = phi_79_;
        let _e43 = (_e40.member < _e40.member_1);
        let _e56 = (bitcast<i32>(select(0u, 1u, _e43)) != 0i);
        if _e56 {
            atomicStore((&counts[((select(type_9().member_1, _e40.member, _e43) * 256u) + _e27)]), 0u);
        }
        continue;
        continuing {
            phi_79_ = type_9(select(_e40.member, (_e40.member + 1u), _e43), select(_e40.member_1, _e40.member_1, _e43));
            break if !(_e56);
        }
    }
    workgroupBarrier();
    let _e63 = params.member.member_1.member;
    let _e66 = params.member.member_1.member_1;
    phi_122_ = (_e66 + ((_e25.y * _e26.x) + _e25.x));
    loop {
        let _e69 = phi_122_;
        let _e70 = (_e63 / 2048u);
        let _e75 = (_e69 < select(_e70, (_e70 + 1u), ((_e63 % 2048u) > 0u)));
        if _e75 {
            let _e77 = ((_e69 * 2048u) + _e27);
            if (_e77 < _e63) {
                let _e80 = keys.member[_e77];
                phi_164_ = _e80;
            } else {
                phi_164_ = 4294967295u;
            }
            let _e82 = phi_164_;
            let _e83 = (_e77 + 256u);
            if (_e83 < _e63) {
                let _e86 = keys.member[_e83];
                phi_180_ = _e86;
            } else {
                phi_180_ = 4294967295u;
            }
            let _e88 = phi_180_;
            let _e89 = (_e77 + 512u);
            if (_e89 < _e63) {
                let _e92 = keys.member[_e89];
                phi_196_ = _e92;
            } else {
                phi_196_ = 4294967295u;
            }
            let _e94 = phi_196_;
            let _e95 = (_e77 + 768u);
            if (_e95 < _e63) {
                let _e98 = keys.member[_e95];
                phi_212_ = _e98;
            } else {
                phi_212_ = 4294967295u;
            }
            let _e100 = phi_212_;
            let _e101 = (_e77 + 1024u);
            if (_e101 < _e63) {
                let _e104 = keys.member[_e101];
                phi_228_ = _e104;
            } else {
                phi_228_ = 4294967295u;
            }
            let _e106 = phi_228_;
            let _e107 = (_e77 + 1280u);
            if (_e107 < _e63) {
                let _e110 = keys.member[_e107];
                phi_244_ = _e110;
            } else {
                phi_244_ = 4294967295u;
            }
            let _e112 = phi_244_;
            let _e113 = (_e77 + 1536u);
            if (_e113 < _e63) {
                let _e116 = keys.member[_e113];
                phi_260_ = _e116;
            } else {
                phi_260_ = 4294967295u;
            }
            let _e118 = phi_260_;
            let _e119 = (_e77 + 1792u);
            if (_e119 < _e63) {
                let _e122 = keys.member[_e119];
                phi_276_ = _e122;
            } else {
                phi_276_ = 4294967295u;
            }
            let _e124 = phi_276_;
            if (_e77 < _e63) {
                phi_284_ = type_9(0u, 4u);
                loop {
                    let _e127 = phi_284_;
                    let _e130 = (_e127.member < _e127.member_1);
                    let _e141 = select(type_9().member_1, _e127.member, _e130);
                    let _e143 = (bitcast<i32>(select(0u, 1u, _e130)) != 0i);
                    if _e143 {
                        let _e152 = atomicAdd((&counts[((_e141 * 256u) + ((_e82 >> bitcast<u32>(((8u * _e141) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_284_ = type_9(select(_e127.member, (_e127.member + 1u), _e130), select(_e127.member_1, _e127.member_1, _e130));
                        break if !(_e143);
                    }
                }
            }
            if ((_e77 + 256u) < _e63) {
                phi_331_ = type_9(0u, 4u);
                loop {
                    let _e157 = phi_331_;
                    let _e160 = (_e157.member < _e157.member_1);
                    let _e171 = select(type_9().member_1, _e157.member, _e160);
                    let _e173 = (bitcast<i32>(select(0u, 1u, _e160)) != 0i);
                    if _e173 {
                        let _e182 = atomicAdd((&counts[((_e171 * 256u) + ((_e88 >> bitcast<u32>(((8u * _e171) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_331_ = type_9(select(_e157.member, (_e157.member + 1u), _e160), select(_e157.member_1, _e157.member_1, _e160));
                        break if !(_e173);
                    }
                }
            }
            if ((_e77 + 512u) < _e63) {
                phi_378_ = type_9(0u, 4u);
                loop {
                    let _e187 = phi_378_;
                    let _e190 = (_e187.member < _e187.member_1);
                    let _e201 = select(type_9().member_1, _e187.member, _e190);
                    let _e203 = (bitcast<i32>(select(0u, 1u, _e190)) != 0i);
                    if _e203 {
                        let _e212 = atomicAdd((&counts[((_e201 * 256u) + ((_e94 >> bitcast<u32>(((8u * _e201) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_378_ = type_9(select(_e187.member, (_e187.member + 1u), _e190), select(_e187.member_1, _e187.member_1, _e190));
                        break if !(_e203);
                    }
                }
            }
            if ((_e77 + 768u) < _e63) {
                phi_425_ = type_9(0u, 4u);
                loop {
                    let _e217 = phi_425_;
                    let _e220 = (_e217.member < _e217.member_1);
                    let _e231 = select(type_9().member_1, _e217.member, _e220);
                    let _e233 = (bitcast<i32>(select(0u, 1u, _e220)) != 0i);
                    if _e233 {
                        let _e242 = atomicAdd((&counts[((_e231 * 256u) + ((_e100 >> bitcast<u32>(((8u * _e231) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_425_ = type_9(select(_e217.member, (_e217.member + 1u), _e220), select(_e217.member_1, _e217.member_1, _e220));
                        break if !(_e233);
                    }
                }
            }
            if ((_e77 + 1024u) < _e63) {
                phi_472_ = type_9(0u, 4u);
                loop {
                    let _e247 = phi_472_;
                    let _e250 = (_e247.member < _e247.member_1);
                    let _e261 = select(type_9().member_1, _e247.member, _e250);
                    let _e263 = (bitcast<i32>(select(0u, 1u, _e250)) != 0i);
                    if _e263 {
                        let _e272 = atomicAdd((&counts[((_e261 * 256u) + ((_e106 >> bitcast<u32>(((8u * _e261) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_472_ = type_9(select(_e247.member, (_e247.member + 1u), _e250), select(_e247.member_1, _e247.member_1, _e250));
                        break if !(_e263);
                    }
                }
            }
            if ((_e77 + 1280u) < _e63) {
                phi_519_ = type_9(0u, 4u);
                loop {
                    let _e277 = phi_519_;
                    let _e280 = (_e277.member < _e277.member_1);
                    let _e291 = select(type_9().member_1, _e277.member, _e280);
                    let _e293 = (bitcast<i32>(select(0u, 1u, _e280)) != 0i);
                    if _e293 {
                        let _e302 = atomicAdd((&counts[((_e291 * 256u) + ((_e112 >> bitcast<u32>(((8u * _e291) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_519_ = type_9(select(_e277.member, (_e277.member + 1u), _e280), select(_e277.member_1, _e277.member_1, _e280));
                        break if !(_e293);
                    }
                }
            }
            if ((_e77 + 1536u) < _e63) {
                phi_566_ = type_9(0u, 4u);
                loop {
                    let _e307 = phi_566_;
                    let _e310 = (_e307.member < _e307.member_1);
                    let _e321 = select(type_9().member_1, _e307.member, _e310);
                    let _e323 = (bitcast<i32>(select(0u, 1u, _e310)) != 0i);
                    if _e323 {
                        let _e332 = atomicAdd((&counts[((_e321 * 256u) + ((_e118 >> bitcast<u32>(((8u * _e321) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_566_ = type_9(select(_e307.member, (_e307.member + 1u), _e310), select(_e307.member_1, _e307.member_1, _e310));
                        break if !(_e323);
                    }
                }
            }
            if ((_e77 + 1792u) < _e63) {
                phi_613_ = type_9(0u, 4u);
                loop {
                    let _e337 = phi_613_;
                    let _e340 = (_e337.member < _e337.member_1);
                    let _e351 = select(type_9().member_1, _e337.member, _e340);
                    let _e353 = (bitcast<i32>(select(0u, 1u, _e340)) != 0i);
                    if _e353 {
                        let _e362 = atomicAdd((&counts[((_e351 * 256u) + ((_e124 >> bitcast<u32>(((8u * _e351) & 31u))) & 255u))]), 1u);
                    }
                    continue;
                    continuing {
                        phi_613_ = type_9(select(_e337.member, (_e337.member + 1u), _e340), select(_e337.member_1, _e337.member_1, _e340));
                        break if !(_e353);
                    }
                }
            }
            phi_123_ = (_e69 + (_e26.x * _e26.y));
        } else {
            phi_123_ = u32();
        }
        let _e366 = phi_123_;
        continue;
        continuing {
            phi_122_ = _e366;
            break if !(_e75);
        }
    }
    workgroupBarrier();
    phi_656_ = type_9(0u, 4u);
    loop {
        let _e369 = phi_656_;
        let _e372 = (_e369.member < _e369.member_1);
        let _e385 = (bitcast<i32>(select(0u, 1u, _e372)) != 0i);
        if _e385 {
            let _e387 = ((select(type_9().member_1, _e369.member, _e372) * 256u) + _e27);
            let _e389 = atomicLoad((&counts[_e387]));
            if (_e389 > 0u) {
                let _e392 = atomicAdd((&table.member[_e387]), _e389);
            }
        }
        continue;
        continuing {
            phi_656_ = type_9(select(_e369.member, (_e369.member + 1u), _e372), select(_e369.member_1, _e369.member_1, _e372));
            break if !(_e385);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
