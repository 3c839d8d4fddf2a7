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
    var phi_239_: type_9;
    var phi_242_: f32;
    var phi_243_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_305_: f32;
    var phi_363_: type_9;
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
            let _e56 = (_e53.member < _e53.member_1);
            let _e67 = select(type_9().member_1, _e53.member, _e56);
            let _e69 = (bitcast<i32>(select(0u, 1u, _e56)) != 0i);
            if _e69 {
                let _e71 = bounds.member[_e67];
                let _e72 = ~(_e71);
                local_1.member[_e67] = bitcast<f32>(select(~(_e72), (_e72 & 2147483647u), ((_e72 >> bitcast<u32>(31i)) == 1u)));
                let _e84 = bounds.member[(3u + _e67)];
                local_1.member_1[_e67] = bitcast<f32>(select(~(_e84), (_e84 & 2147483647u), ((_e84 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_129_ = type_9(select(_e53.member, (_e53.member + 1u), _e56), select(_e53.member_1, _e53.member_1, _e56));
                break if !(_e69);
            }
        }
        let _e95 = local_1;
        local_3 = _e95;
        phi_239_ = type_9(0u, 3u);
        phi_242_ = 0f;
        loop {
            let _e97 = phi_239_;
            let _e99 = phi_242_;
            local_5 = _e99;
            local_6 = _e99;
            let _e102 = (_e97.member < _e97.member_1);
            let _e113 = select(type_9().member_1, _e97.member, _e102);
            let _e115 = (bitcast<i32>(select(0u, 1u, _e102)) != 0i);
            if _e115 {
                let _e118 = local_3.member_1[_e113];
                let _e122 = local_3.member[_e113];
                let _e124 = ((_e118 * 0.5f) - (_e122 * 0.5f));
                phi_243_ = select(_e99, _e124, (_e124 > _e99));
            } else {
                phi_243_ = f32();
            }
            let _e128 = phi_243_;
            continue;
            continuing {
                phi_239_ = type_9(select(_e97.member, (_e97.member + 1u), _e102), select(_e97.member_1, _e97.member_1, _e102));
                phi_242_ = _e128;
                break if !(_e115);
            }
        }
        let _e131 = local_5;
        if (_e131 > 0.000000000000000000000000000001f) {
            let _e135 = local_6;
            phi_305_ = ((0.5f * 1024f) / _e135);
        } else {
            phi_305_ = 0f;
        }
        let _e138 = phi_305_;
        let _e140 = local_3.member;
        local_2 = type_22(_e140, _e138, (1024f - 1f));
        let _e146 = params.member.member.member_2[_e46];
        let _e149 = boxes.member[(_e146 + _e43)];
        local_4 = type_21(array<f32, 3>(_e149.member.x, _e149.member.y, _e149.member_1.x), array<f32, 3>(_e149.member_1.y, _e149.member_2.x, _e149.member_2.y));
        local = type_21(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_363_ = type_9(0u, 3u);
        loop {
            let _e166 = phi_363_;
            let _e169 = (_e166.member < _e166.member_1);
            let _e180 = select(type_9().member_1, _e166.member, _e169);
            let _e182 = (bitcast<i32>(select(0u, 1u, _e169)) != 0i);
            if _e182 {
                let _e185 = local_2.member[_e180];
                let _e186 = (_e185 * 0.5f);
                let _e189 = local_4.member[_e180];
                let _e193 = local_2.member_1;
                local.member[_e180] = (((_e189 * 0.5f) - _e186) * _e193);
                let _e199 = local_4.member_1[_e180];
                let _e203 = local_2.member_1;
                local.member_1[_e180] = (((_e199 * 0.5f) - _e186) * _e203);
            }
            continue;
            continuing {
                phi_363_ = type_9(select(_e166.member, (_e166.member + 1u), _e169), select(_e166.member_1, _e166.member_1, _e169));
                break if !(_e182);
            }
        }
        let _e208 = local;
        clusters.member[_e43] = type_26(vec4<u32>(bitcast<u32>(_e208.member[0]), bitcast<u32>(_e208.member[1]), bitcast<u32>(_e208.member[2]), ((_e50 - 1u) + _e43)), vec4<u32>(bitcast<u32>(_e208.member_1[0]), bitcast<u32>(_e208.member_1[1]), bitcast<u32>(_e208.member_1[2]), 1u));
        items.member[_e43] = vec4<u32>(bitcast<u32>((_e208.member[0] + _e208.member_1[0])), bitcast<u32>((_e208.member[1] + _e208.member_1[1])), bitcast<u32>((_e208.member[2] + _e208.member_1[2])), _e43);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
