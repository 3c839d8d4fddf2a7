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
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_7,
    member_1: type_8,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(1) 
var<storage> levels: type_11;
@group(0) @binding(2) 
var<storage> present: type_11;
@group(0) @binding(3) 
var<storage> table: type_11;
@group(0) @binding(4) 
var<storage, read_write> entries: type_11;
@group(0) @binding(5) 
var<storage, read_write> list: type_11;
var<workgroup> masks: array<atomic<u32>, 768>;
var<workgroup> begins: array<u32, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: array<u32, 3>;
    var phi_117_: type_9;
    var phi_159_: type_9;
    var phi_162_: u32;
    var phi_163_: u32;
    var local_2: u32;
    var phi_273_: u32;
    var phi_295_: u32;
    var phi_312_: type_9;
    var phi_315_: u32;
    var phi_316_: u32;
    var phi_378_: type_9;
    var phi_381_: u32;
    var phi_382_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_439_: array<u32, 2>;
    var phi_445_: type_9;
    var phi_488_: type_9;
    var phi_538_: type_9;
    var phi_541_: u32;
    var phi_542_: u32;
    var local_5: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e28 = id_2;
    let _e29 = n_2;
    let _e30 = lane_2;
    let _e41 = ((_e28.y * _e29.x) + _e28.x);
    let _e44 = params.member.member_2.member;
    let _e48 = params.member.member.member[_e44];
    let _e49 = (_e48 - 1u);
    let _e50 = (_e49 / 256u);
    let _e54 = select(_e50, (_e50 + 1u), ((_e49 % 256u) > 0u));
    let _e56 = ((_e41 * 256u) + _e30);
    phi_117_ = type_9(0u, 3u);
    loop {
        let _e58 = phi_117_;
        let _e61 = (_e58.member < _e58.member_1);
        let _e74 = (bitcast<i32>(select(0u, 1u, _e61)) != 0i);
        if _e74 {
            atomicStore((&masks[((select(type_9().member_1, _e58.member, _e61) * 256u) + _e30)]), 0u);
        }
        continue;
        continuing {
            phi_117_ = type_9(select(_e58.member, (_e58.member + 1u), _e61), select(_e58.member_1, _e58.member_1, _e61));
            break if !(_e74);
        }
    }
    phi_159_ = type_9(0u, select(_e30, 96u, (96u < _e30)));
    phi_162_ = 0u;
    loop {
        let _e83 = phi_159_;
        let _e85 = phi_162_;
        local_2 = _e85;
        let _e88 = (_e83.member < _e83.member_1);
        let _e101 = (bitcast<i32>(select(0u, 1u, _e88)) != 0i);
        if _e101 {
            let _e105 = table.member[((256u * _e54) + select(type_9().member_1, _e83.member, _e88))];
            phi_163_ = (_e85 + _e105);
        } else {
            phi_163_ = u32();
        }
        let _e108 = phi_163_;
        continue;
        continuing {
            phi_159_ = type_9(select(_e83.member, (_e83.member + 1u), _e88), select(_e83.member_1, _e83.member_1, _e88));
            phi_162_ = _e108;
            break if !(_e101);
        }
    }
    let _e112 = local_2;
    begins[_e30] = _e112;
    workgroupBarrier();
    if (_e56 < _e49) {
        let _e115 = present.member[0u];
        let _e117 = present.member[1u];
        let _e119 = present.member[2u];
        let _e121 = levels.member[_e56];
        if (_e56 > 0u) {
            let _e125 = levels.member[(_e56 - 1u)];
            phi_273_ = select(_e125, _e121, (_e125 < _e121));
        } else {
            phi_273_ = _e121;
        }
        let _e129 = phi_273_;
        if ((_e56 + 1u) < _e49) {
            let _e134 = levels.member[(_e56 + 1u)];
            phi_295_ = select(_e134, _e129, (_e134 < _e129));
        } else {
            phi_295_ = _e129;
        }
        let _e138 = phi_295_;
        let _e140 = levels.member[_e56];
        local_1 = array<u32, 3>(_e115, _e117, _e119);
        phi_312_ = type_9(0u, 3u);
        phi_315_ = 0u;
        loop {
            let _e143 = phi_312_;
            let _e145 = phi_315_;
            local_3 = _e145;
            let _e148 = (_e143.member < _e143.member_1);
            let _e159 = select(type_9().member_1, _e143.member, _e148);
            let _e161 = (bitcast<i32>(select(0u, 1u, _e148)) != 0i);
            if _e161 {
                let _e162 = (32u * _e159);
                let _e174 = local_1[_e159];
                phi_316_ = (_e145 + countOneBits((_e174 & select(select(0u, ((1u << bitcast<u32>(((_e140 - _e162) & 31u))) - 1u), (_e140 > _e162)), 4294967295u, (_e140 >= (_e162 + 32u))))));
            } else {
                phi_316_ = u32();
            }
            let _e179 = phi_316_;
            continue;
            continuing {
                phi_312_ = type_9(select(_e143.member, (_e143.member + 1u), _e148), select(_e143.member_1, _e143.member_1, _e148));
                phi_315_ = _e179;
                break if !(_e161);
            }
        }
        local = array<u32, 3>(_e115, _e117, _e119);
        phi_378_ = type_9(0u, 3u);
        phi_381_ = 0u;
        loop {
            let _e183 = phi_378_;
            let _e185 = phi_381_;
            local_4 = _e185;
            let _e188 = (_e183.member < _e183.member_1);
            let _e199 = select(type_9().member_1, _e183.member, _e188);
            let _e201 = (bitcast<i32>(select(0u, 1u, _e188)) != 0i);
            if _e201 {
                let _e202 = (32u * _e199);
                let _e214 = local[_e199];
                phi_382_ = (_e185 + countOneBits((_e214 & select(select(0u, ((1u << bitcast<u32>(((_e138 - _e202) & 31u))) - 1u), (_e138 > _e202)), 4294967295u, (_e138 >= (_e202 + 32u))))));
            } else {
                phi_382_ = u32();
            }
            let _e219 = phi_382_;
            continue;
            continuing {
                phi_378_ = type_9(select(_e183.member, (_e183.member + 1u), _e188), select(_e183.member_1, _e183.member_1, _e188));
                phi_381_ = _e219;
                break if !(_e201);
            }
        }
        let _e222 = local_3;
        let _e224 = local_4;
        phi_439_ = array<u32, 2>(_e222, _e224);
    } else {
        phi_439_ = array<u32, 2>(1u, 0u);
    }
    let _e227 = phi_439_;
    phi_445_ = type_9(_e227[0], (_e227[1] + 1u));
    loop {
        let _e233 = phi_445_;
        let _e236 = (_e233.member < _e233.member_1);
        let _e249 = (bitcast<i32>(select(0u, 1u, _e236)) != 0i);
        if _e249 {
            let _e258 = atomicOr((&masks[((select(type_9().member_1, _e233.member, _e236) * 8u) + (_e30 / 32u))]), (1u << bitcast<u32>(((_e30 % 32u) & 31u))));
        }
        continue;
        continuing {
            phi_445_ = type_9(select(_e233.member, (_e233.member + 1u), _e236), select(_e233.member_1, _e233.member_1, _e236));
            break if !(_e249);
        }
    }
    workgroupBarrier();
    phi_488_ = type_9(_e227[0], (_e227[1] + 1u));
    loop {
        let _e263 = phi_488_;
        let _e266 = (_e263.member < _e263.member_1);
        let _e277 = select(type_9().member_1, _e263.member, _e266);
        let _e279 = (bitcast<i32>(select(0u, 1u, _e266)) != 0i);
        if _e279 {
            let _e281 = begins[_e277];
            let _e285 = table.member[((_e277 * _e54) + _e41)];
            phi_538_ = type_9(0u, (_e30 / 32u));
            phi_541_ = (_e281 + _e285);
            loop {
                let _e290 = phi_538_;
                let _e292 = phi_541_;
                local_5 = _e292;
                let _e295 = (_e290.member < _e290.member_1);
                let _e308 = (bitcast<i32>(select(0u, 1u, _e295)) != 0i);
                if _e308 {
                    let _e312 = atomicLoad((&masks[((_e277 * 8u) + select(type_9().member_1, _e290.member, _e295))]));
                    phi_542_ = (_e292 + countOneBits(_e312));
                } else {
                    phi_542_ = u32();
                }
                let _e316 = phi_542_;
                continue;
                continuing {
                    phi_538_ = type_9(select(_e290.member, (_e290.member + 1u), _e295), select(_e290.member_1, _e290.member_1, _e295));
                    phi_541_ = _e316;
                    break if !(_e308);
                }
            }
            let _e322 = atomicLoad((&masks[((_e277 * 8u) + (_e30 / 32u))]));
            let _e331 = local_5;
            let _e332 = (_e331 + countOneBits((_e322 & ((1u << bitcast<u32>(((_e30 % 32u) & 31u))) - 1u))));
            let _e335 = params.member.member_1.member_3;
            if (_e332 < _e335) {
                list.member[(4u + _e332)] = _e56;
            }
            if (_e277 == _e227[0]) {
                entries.member[_e56] = _e332;
            }
        }
        continue;
        continuing {
            phi_488_ = type_9(select(_e263.member, (_e263.member + 1u), _e266), select(_e263.member_1, _e263.member_1, _e266));
            break if !(_e279);
        }
    }
    if (_e56 == 0u) {
        let _e344 = begins[96u];
        list.member[0u] = _e344;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn split_emit(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
