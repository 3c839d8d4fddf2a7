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
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_24 {
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_26 {
    member: array<type_24>,
}

@group(0) @binding(3) 
var<storage> order: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(2) 
var<storage> bounds: type_11;
@group(0) @binding(4) 
var<storage, read_write> clusters: type_26;
@group(0) @binding(5) 
var<storage, read_write> names: type_11;
@group(0) @binding(6) 
var<storage, read_write> counts: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var local_1: type_19;
    var local_2: type_20;
    var local_3: type_19;
    var local_4: type_19;
    var phi_129_: type_9;
    var phi_130_: type_9;
    var phi_153_: type_9;
    var phi_179_: u32;
    var phi_205_: u32;
    var phi_239_: type_9;
    var phi_242_: f32;
    var phi_240_: type_9;
    var phi_265_: type_9;
    var phi_295_: f32;
    var phi_243_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_305_: f32;
    var phi_373_: type_9;
    var phi_374_: type_9;
    var phi_397_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e31 = id_2;
    let _e32 = n_2;
    let _e33 = lane_2;
    let _e47 = ((((_e31.y * _e32.x) + _e31.x) * 256u) + _e33);
    let _e50 = params.member.member_2.member;
    let _e54 = params.member.member.member[_e50];
    if (_e47 < _e54) {
        local_1 = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_129_ = type_9(0u, 3u);
        loop {
            let _e57 = phi_129_;
            if (_e57.member < _e57.member_1) {
                phi_130_ = type_9((_e57.member + 1u), _e57.member_1);
                phi_153_ = type_9(1u, _e57.member);
            } else {
                phi_130_ = _e57;
                phi_153_ = type_9(0u, type_9().member_1);
            }
            let _e69 = phi_130_;
            let _e71 = phi_153_;
            let _e75 = (bitcast<i32>(_e71.member) != 0i);
            if _e75 {
                let _e77 = bounds.member[_e71.member_1];
                let _e78 = ~(_e77);
                if ((_e78 >> bitcast<u32>(31i)) == 1u) {
                    phi_179_ = (_e78 & 2147483647u);
                } else {
                    phi_179_ = ~(_e78);
                }
                let _e85 = phi_179_;
                local_1.member[_e71.member_1] = bitcast<f32>(_e85);
                let _e91 = bounds.member[(3u + _e71.member_1)];
                if ((_e91 >> bitcast<u32>(31i)) == 1u) {
                    phi_205_ = (_e91 & 2147483647u);
                } else {
                    phi_205_ = ~(_e91);
                }
                let _e98 = phi_205_;
                local_1.member_1[_e71.member_1] = bitcast<f32>(_e98);
            }
            continue;
            continuing {
                phi_129_ = _e69;
                break if !(_e75);
            }
        }
        let _e103 = local_1;
        local_3 = _e103;
        phi_239_ = type_9(0u, 3u);
        phi_242_ = 0f;
        loop {
            let _e105 = phi_239_;
            let _e107 = phi_242_;
            local_5 = _e107;
            local_6 = _e107;
            if (_e105.member < _e105.member_1) {
                phi_240_ = type_9((_e105.member + 1u), _e105.member_1);
                phi_265_ = type_9(1u, _e105.member);
            } else {
                phi_240_ = _e105;
                phi_265_ = type_9(0u, type_9().member_1);
            }
            let _e119 = phi_240_;
            let _e121 = phi_265_;
            let _e125 = (bitcast<i32>(_e121.member) != 0i);
            if _e125 {
                let _e128 = local_3.member_1[_e121.member_1];
                let _e132 = local_3.member[_e121.member_1];
                let _e134 = ((_e128 * 0.5f) - (_e132 * 0.5f));
                if (_e134 > _e107) {
                    phi_295_ = _e134;
                } else {
                    phi_295_ = _e107;
                }
                let _e137 = phi_295_;
                phi_243_ = _e137;
            } else {
                phi_243_ = f32();
            }
            let _e139 = phi_243_;
            continue;
            continuing {
                phi_239_ = _e119;
                phi_242_ = _e139;
                break if !(_e125);
            }
        }
        let _e142 = local_5;
        if (_e142 > 0.000000000000000000000000000001f) {
            let _e146 = local_6;
            phi_305_ = ((0.5f * 1024f) / _e146);
        } else {
            phi_305_ = 0f;
        }
        let _e149 = phi_305_;
        let _e151 = local_3.member;
        local_2 = type_20(_e151, _e149, (1024f - 1f));
        let _e157 = params.member.member.member_2[_e50];
        let _e160 = order.member[(_e157 + _e47)];
        let _e162 = boxes.member[_e160];
        local_4 = type_19(array<f32, 3>(_e162.member.x, _e162.member.y, _e162.member_1.x), array<f32, 3>(_e162.member_1.y, _e162.member_2.x, _e162.member_2.y));
        local = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_373_ = type_9(0u, 3u);
        loop {
            let _e179 = phi_373_;
            if (_e179.member < _e179.member_1) {
                phi_374_ = type_9((_e179.member + 1u), _e179.member_1);
                phi_397_ = type_9(1u, _e179.member);
            } else {
                phi_374_ = _e179;
                phi_397_ = type_9(0u, type_9().member_1);
            }
            let _e191 = phi_374_;
            let _e193 = phi_397_;
            let _e197 = (bitcast<i32>(_e193.member) != 0i);
            if _e197 {
                let _e200 = local_2.member[_e193.member_1];
                let _e201 = (_e200 * 0.5f);
                let _e204 = local_4.member[_e193.member_1];
                let _e208 = local_2.member_1;
                local.member[_e193.member_1] = (((_e204 * 0.5f) - _e201) * _e208);
                let _e214 = local_4.member_1[_e193.member_1];
                let _e218 = local_2.member_1;
                local.member_1[_e193.member_1] = (((_e214 * 0.5f) - _e201) * _e218);
            }
            continue;
            continuing {
                phi_373_ = _e191;
                break if !(_e197);
            }
        }
        let _e223 = local;
        clusters.member[_e47] = type_24(vec4<u32>(bitcast<u32>(_e223.member[0]), bitcast<u32>(_e223.member[1]), bitcast<u32>(_e223.member[2]), ((_e54 - 1u) + _e47)), vec4<u32>(bitcast<u32>(_e223.member_1[0]), bitcast<u32>(_e223.member_1[1]), bitcast<u32>(_e223.member_1[2]), 1u));
        names.member[_e47] = _e47;
    }
    if (_e47 == 0u) {
        counts.member[0u] = _e54;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
