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

struct type_16 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_22 {
    member: array<type_20>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> neighbours: type_11;
var<workgroup> masks: array<atomic<u32>, 8>;
@group(0) @binding(6) 
var<storage, read_write> counts: type_11;
@group(0) @binding(2) 
var<storage> clusters: type_22;
@group(0) @binding(3) 
var<storage> names: type_11;
@group(0) @binding(4) 
var<storage, read_write> clusters_out: type_22;
@group(0) @binding(5) 
var<storage, read_write> names_out: type_11;
@group(0) @binding(7) 
var<storage, read_write> joins: type_11;
var<workgroup> sums: array<atomic<u32>, 2>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_225_: u32;
    var phi_244_: type_9;
    var phi_247_: u32;
    var phi_249_: u32;
    var phi_297_: u32;
    var phi_248_: u32;
    var phi_250_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_396_: type_9;
    var phi_399_: u32;
    var phi_400_: u32;
    var phi_582_: type_16;
    var local_3: u32;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e28 = id_2;
    let _e29 = n_2;
    let _e30 = lane_2;
    let _e43 = ((_e28.y * _e29.x) + _e28.x);
    let _e46 = params.member.member_1.member_1;
    let _e48 = counts.member[_e46];
    let _e50 = select(0u, _e48, (_e48 > 256u));
    let _e53 = params.member.member_2.member;
    let _e57 = params.member.member.member[_e53];
    let _e59 = ((_e43 * 256u) + _e30);
    if (_e30 < 2u) {
        atomicStore((&sums[_e30]), 0u);
    }
    if (_e30 < 8u) {
        atomicStore((&masks[_e30]), 0u);
    }
    workgroupBarrier();
    let _e64 = (_e50 / 256u);
    let _e68 = select(_e64, (_e64 + 1u), ((_e50 % 256u) > 0u));
    let _e69 = (_e68 / 256u);
    let _e73 = select(_e69, (_e69 + 1u), ((_e68 % 256u) > 0u));
    let _e76 = (((_e43 / 256u) * 256u) + _e30);
    let _e80 = (_e57 / 256u);
    let _e84 = select(_e80, (_e80 + 1u), ((_e57 % 256u) > 0u));
    let _e85 = (_e84 / 256u);
    if select(false, (_e76 < _e68), (_e76 < _e43)) {
        let _e93 = counts.member[(192u + (select(_e85, (_e85 + 1u), ((_e84 % 256u) > 0u)) + _e76))];
        phi_225_ = _e93;
    } else {
        phi_225_ = 0u;
    }
    let _e95 = phi_225_;
    let _e96 = (_e73 / 256u);
    phi_244_ = type_9(0u, select(_e96, (_e96 + 1u), ((_e73 % 256u) > 0u)));
    phi_247_ = 0u;
    phi_249_ = 0u;
    loop {
        let _e103 = phi_244_;
        let _e105 = phi_247_;
        let _e107 = phi_249_;
        local = _e107;
        local_1 = _e107;
        local_2 = _e105;
        let _e110 = (_e103.member < _e103.member_1);
        let _e123 = (bitcast<i32>(select(0u, 1u, _e110)) != 0i);
        if _e123 {
            let _e125 = ((select(type_9().member_1, _e103.member, _e110) * 256u) + _e30);
            if (_e125 < _e73) {
                let _e129 = counts.member[(192u + _e125)];
                phi_297_ = _e129;
            } else {
                phi_297_ = 0u;
            }
            let _e131 = phi_297_;
            phi_248_ = (_e105 + select(_e131, 0u, (_e125 < (_e43 / 256u))));
            phi_250_ = (_e107 + select(0u, _e131, (_e125 < (_e43 / 256u))));
        } else {
            phi_248_ = u32();
            phi_250_ = u32();
        }
        let _e141 = phi_248_;
        let _e143 = phi_250_;
        continue;
        continuing {
            phi_244_ = type_9(select(_e103.member, (_e103.member + 1u), _e110), select(_e103.member_1, _e103.member_1, _e110));
            phi_247_ = _e141;
            phi_249_ = _e143;
            break if !(_e123);
        }
    }
    let _e146 = local;
    let _e149 = atomicAdd((&sums[0u]), (_e146 + _e95));
    let _e151 = local_1;
    let _e153 = local_2;
    let _e156 = atomicAdd((&sums[1u]), (_e151 + _e153));
    let _e157 = (_e59 < _e50);
    let _e158 = select(0u, _e59, _e157);
    let _e160 = neighbours.member[_e158];
    let _e162 = neighbours.member[_e160];
    let _e163 = (_e158 == _e160);
    let _e164 = (_e162 != _e158);
    let _e170 = select(select(select(select(2u, 1u, (_e158 < _e160)), u32(), _e164), u32(), _e163), 0u, select(_e164, true, _e163));
    let _e173 = select(false, !((_e170 == 2u)), _e157);
    if _e173 {
        let _e180 = atomicOr((&masks[(_e30 / 32u)]), (1u << bitcast<u32>(((_e30 % 32u) & 31u))));
    }
    workgroupBarrier();
    if _e173 {
        let _e182 = atomicLoad((&sums[0u]));
        let _e185 = atomicLoad((&masks[(_e30 / 32u)]));
        phi_396_ = type_9(0u, (_e30 / 32u));
        phi_399_ = (_e182 + countOneBits((_e185 & ((1u << bitcast<u32>(((_e30 % 32u) & 31u))) - 1u))));
        loop {
            let _e197 = phi_396_;
            let _e199 = phi_399_;
            local_3 = _e199;
            local_4 = _e199;
            let _e202 = (_e197.member < _e197.member_1);
            let _e215 = (bitcast<i32>(select(0u, 1u, _e202)) != 0i);
            if _e215 {
                let _e217 = atomicLoad((&masks[select(type_9().member_1, _e197.member, _e202)]));
                phi_400_ = (_e199 + countOneBits(_e217));
            } else {
                phi_400_ = u32();
            }
            let _e221 = phi_400_;
            continue;
            continuing {
                phi_396_ = type_9(select(_e197.member, (_e197.member + 1u), _e202), select(_e197.member_1, _e197.member_1, _e202));
                phi_399_ = _e221;
                break if !(_e215);
            }
        }
        let _e224 = clusters.member[_e59];
        let _e227 = bitcast<f32>(_e224.member.x);
        let _e229 = bitcast<f32>(_e224.member.y);
        let _e231 = bitcast<f32>(_e224.member.z);
        let _e237 = bitcast<f32>(_e224.member_1.x);
        let _e239 = bitcast<f32>(_e224.member_1.y);
        let _e241 = bitcast<f32>(_e224.member_1.z);
        if (_e170 == 1u) {
            let _e248 = clusters.member[_e160];
            let _e251 = bitcast<f32>(_e248.member.x);
            let _e253 = bitcast<f32>(_e248.member.y);
            let _e255 = bitcast<f32>(_e248.member.z);
            let _e260 = bitcast<f32>(_e248.member_1.x);
            let _e262 = bitcast<f32>(_e248.member_1.y);
            let _e264 = bitcast<f32>(_e248.member_1.z);
            let _e268 = names.member[_e160];
            let _e269 = (_e268 - 1u);
            let _e270 = (_e269 * 4u);
            let _e271 = (_e224.member.w * 4u);
            let _e272 = (_e248.member.w * 4u);
            joins.member[_e271] = _e269;
            joins.member[(_e271 + 1u)] = 0u;
            joins.member[_e272] = _e269;
            joins.member[(_e272 + 1u)] = _e224.member_1.w;
            joins.member[(_e270 + 2u)] = _e224.member_1.w;
            joins.member[(_e270 + 3u)] = (_e224.member_1.w + _e248.member_1.w);
            phi_582_ = type_16(array<f32, 3>(select(_e251, _e227, (_e227 < _e251)), select(_e253, _e229, (_e229 < _e253)), select(_e255, _e231, (_e231 < _e255))), _e269, array<f32, 3>(select(_e260, _e237, (_e237 > _e260)), select(_e262, _e239, (_e239 > _e262)), select(_e264, _e241, (_e241 > _e264))), (_e224.member_1.w + _e248.member_1.w));
        } else {
            phi_582_ = type_16(array<f32, 3>(_e227, _e229, _e231), _e224.member.w, array<f32, 3>(_e237, _e239, _e241), _e224.member_1.w);
        }
        let _e301 = phi_582_;
        let _e322 = local_3;
        clusters_out.member[_e322] = type_20(vec4<u32>(bitcast<u32>(_e301.member[0]), bitcast<u32>(_e301.member[1]), bitcast<u32>(_e301.member[2]), _e301.member_1), vec4<u32>(bitcast<u32>(_e301.member_2[0]), bitcast<u32>(_e301.member_2[1]), bitcast<u32>(_e301.member_2[2]), _e301.member_3));
        let _e325 = names.member[_e59];
        let _e327 = local_4;
        names_out.member[_e327] = _e325;
    }
    if (_e59 == 0u) {
        if (_e50 > 0u) {
            let _e333 = params.member.member_1.member_1;
            let _e336 = atomicLoad((&sums[1u]));
            counts.member[(_e333 + 1u)] = _e336;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_join(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
