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
    member: array<vec4<u32>>,
}

struct type_17 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_23 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_24 {
    member: type_7,
    member_1: type_8,
    member_2: type_23,
}

struct type_25 {
    member: type_24,
}

struct type_26 {
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_28 {
    member: array<type_26>,
}

@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(2) 
var<storage> bounds: type_11;
@group(0) @binding(3) 
var<storage, read_write> clusters: type_28;
@group(0) @binding(4) 
var<storage, read_write> items: type_15;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_21;
    var local_1: type_21;
    var local_2: type_22;
    var local_3: type_21;
    var local_4: type_21;
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
    var phi_363_: type_9;
    var phi_364_: type_9;
    var phi_387_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e43 = ((((_e29.y * _e30.x) + _e29.x) * 256u) + _e31);
    let _e46 = params.member.member_2.member;
    let _e50 = params.member.member.member[_e46];
    if (_e43 < _e50) {
        local_1 = type_21(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_129_ = type_9(0u, 3u);
        loop {
            let _e53 = phi_129_;
            if (_e53.member < _e53.member_1) {
                phi_130_ = type_9((_e53.member + 1u), _e53.member_1);
                phi_153_ = type_9(1u, _e53.member);
            } else {
                phi_130_ = _e53;
                phi_153_ = type_9(0u, type_9().member_1);
            }
            let _e65 = phi_130_;
            let _e67 = phi_153_;
            let _e71 = (bitcast<i32>(_e67.member) != 0i);
            if _e71 {
                let _e73 = bounds.member[_e67.member_1];
                let _e74 = ~(_e73);
                if ((_e74 >> bitcast<u32>(31i)) == 1u) {
                    phi_179_ = (_e74 & 2147483647u);
                } else {
                    phi_179_ = ~(_e74);
                }
                let _e81 = phi_179_;
                local_1.member[_e67.member_1] = bitcast<f32>(_e81);
                let _e87 = bounds.member[(3u + _e67.member_1)];
                if ((_e87 >> bitcast<u32>(31i)) == 1u) {
                    phi_205_ = (_e87 & 2147483647u);
                } else {
                    phi_205_ = ~(_e87);
                }
                let _e94 = phi_205_;
                local_1.member_1[_e67.member_1] = bitcast<f32>(_e94);
            }
            continue;
            continuing {
                phi_129_ = _e65;
                break if !(_e71);
            }
        }
        let _e99 = local_1;
        local_3 = _e99;
        phi_239_ = type_9(0u, 3u);
        phi_242_ = 0f;
        loop {
            let _e101 = phi_239_;
            let _e103 = phi_242_;
            local_5 = _e103;
            local_6 = _e103;
            if (_e101.member < _e101.member_1) {
                phi_240_ = type_9((_e101.member + 1u), _e101.member_1);
                phi_265_ = type_9(1u, _e101.member);
            } else {
                phi_240_ = _e101;
                phi_265_ = type_9(0u, type_9().member_1);
            }
            let _e115 = phi_240_;
            let _e117 = phi_265_;
            let _e121 = (bitcast<i32>(_e117.member) != 0i);
            if _e121 {
                let _e124 = local_3.member_1[_e117.member_1];
                let _e128 = local_3.member[_e117.member_1];
                let _e130 = ((_e124 * 0.5f) - (_e128 * 0.5f));
                if (_e130 > _e103) {
                    phi_295_ = _e130;
                } else {
                    phi_295_ = _e103;
                }
                let _e133 = phi_295_;
                phi_243_ = _e133;
            } else {
                phi_243_ = f32();
            }
            let _e135 = phi_243_;
            continue;
            continuing {
                phi_239_ = _e115;
                phi_242_ = _e135;
                break if !(_e121);
            }
        }
        let _e138 = local_5;
        if (_e138 > 0.000000000000000000000000000001f) {
            let _e142 = local_6;
            phi_305_ = ((0.5f * 1024f) / _e142);
        } else {
            phi_305_ = 0f;
        }
        let _e145 = phi_305_;
        let _e147 = local_3.member;
        local_2 = type_22(_e147, _e145, (1024f - 1f));
        let _e153 = params.member.member.member_2[_e46];
        let _e156 = boxes.member[(_e153 + _e43)];
        local_4 = type_21(array<f32, 3>(_e156.member.x, _e156.member.y, _e156.member_1.x), array<f32, 3>(_e156.member_1.y, _e156.member_2.x, _e156.member_2.y));
        local = type_21(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_363_ = type_9(0u, 3u);
        loop {
            let _e173 = phi_363_;
            if (_e173.member < _e173.member_1) {
                phi_364_ = type_9((_e173.member + 1u), _e173.member_1);
                phi_387_ = type_9(1u, _e173.member);
            } else {
                phi_364_ = _e173;
                phi_387_ = type_9(0u, type_9().member_1);
            }
            let _e185 = phi_364_;
            let _e187 = phi_387_;
            let _e191 = (bitcast<i32>(_e187.member) != 0i);
            if _e191 {
                let _e194 = local_2.member[_e187.member_1];
                let _e195 = (_e194 * 0.5f);
                let _e198 = local_4.member[_e187.member_1];
                let _e202 = local_2.member_1;
                local.member[_e187.member_1] = (((_e198 * 0.5f) - _e195) * _e202);
                let _e208 = local_4.member_1[_e187.member_1];
                let _e212 = local_2.member_1;
                local.member_1[_e187.member_1] = (((_e208 * 0.5f) - _e195) * _e212);
            }
            continue;
            continuing {
                phi_363_ = _e185;
                break if !(_e191);
            }
        }
        let _e217 = local;
        clusters.member[_e43] = type_26(vec4<u32>(bitcast<u32>(_e217.member[0]), bitcast<u32>(_e217.member[1]), bitcast<u32>(_e217.member[2]), ((_e50 - 1u) + _e43)), vec4<u32>(bitcast<u32>(_e217.member_1[0]), bitcast<u32>(_e217.member_1[1]), bitcast<u32>(_e217.member_1[2]), 1u));
        items.member[_e43] = vec4<u32>(bitcast<u32>((_e217.member[0] + _e217.member_1[0])), bitcast<u32>((_e217.member[1] + _e217.member_1[1])), bitcast<u32>((_e217.member[2] + _e217.member_1[2])), _e43);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
