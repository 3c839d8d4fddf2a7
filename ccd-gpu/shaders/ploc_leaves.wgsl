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
    var phi_239_: type_9;
    var phi_242_: f32;
    var phi_243_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_305_: f32;
    var phi_373_: type_9;
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
            let _e60 = (_e57.member < _e57.member_1);
            let _e71 = select(type_9().member_1, _e57.member, _e60);
            let _e73 = (bitcast<i32>(select(0u, 1u, _e60)) != 0i);
            if _e73 {
                let _e75 = bounds.member[_e71];
                let _e76 = ~(_e75);
                local_1.member[_e71] = bitcast<f32>(select(~(_e76), (_e76 & 2147483647u), ((_e76 >> bitcast<u32>(31i)) == 1u)));
                let _e88 = bounds.member[(3u + _e71)];
                local_1.member_1[_e71] = bitcast<f32>(select(~(_e88), (_e88 & 2147483647u), ((_e88 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_129_ = type_9(select(_e57.member, (_e57.member + 1u), _e60), select(_e57.member_1, _e57.member_1, _e60));
                break if !(_e73);
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
            let _e106 = (_e101.member < _e101.member_1);
            let _e117 = select(type_9().member_1, _e101.member, _e106);
            let _e119 = (bitcast<i32>(select(0u, 1u, _e106)) != 0i);
            if _e119 {
                let _e122 = local_3.member_1[_e117];
                let _e126 = local_3.member[_e117];
                let _e128 = ((_e122 * 0.5f) - (_e126 * 0.5f));
                phi_243_ = select(_e103, _e128, (_e128 > _e103));
            } else {
                phi_243_ = f32();
            }
            let _e132 = phi_243_;
            continue;
            continuing {
                phi_239_ = type_9(select(_e101.member, (_e101.member + 1u), _e106), select(_e101.member_1, _e101.member_1, _e106));
                phi_242_ = _e132;
                break if !(_e119);
            }
        }
        let _e135 = local_5;
        if (_e135 > 0.000000000000000000000000000001f) {
            let _e139 = local_6;
            phi_305_ = ((0.5f * 1024f) / _e139);
        } else {
            phi_305_ = 0f;
        }
        let _e142 = phi_305_;
        let _e144 = local_3.member;
        local_2 = type_20(_e144, _e142, (1024f - 1f));
        let _e150 = params.member.member.member_2[_e50];
        let _e153 = order.member[(_e150 + _e47)];
        let _e155 = boxes.member[_e153];
        local_4 = type_19(array<f32, 3>(_e155.member.x, _e155.member.y, _e155.member_1.x), array<f32, 3>(_e155.member_1.y, _e155.member_2.x, _e155.member_2.y));
        local = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_373_ = type_9(0u, 3u);
        loop {
            let _e172 = phi_373_;
            let _e175 = (_e172.member < _e172.member_1);
            let _e186 = select(type_9().member_1, _e172.member, _e175);
            let _e188 = (bitcast<i32>(select(0u, 1u, _e175)) != 0i);
            if _e188 {
                let _e191 = local_2.member[_e186];
                let _e192 = (_e191 * 0.5f);
                let _e195 = local_4.member[_e186];
                let _e199 = local_2.member_1;
                local.member[_e186] = (((_e195 * 0.5f) - _e192) * _e199);
                let _e205 = local_4.member_1[_e186];
                let _e209 = local_2.member_1;
                local.member_1[_e186] = (((_e205 * 0.5f) - _e192) * _e209);
            }
            continue;
            continuing {
                phi_373_ = type_9(select(_e172.member, (_e172.member + 1u), _e175), select(_e172.member_1, _e172.member_1, _e175));
                break if !(_e188);
            }
        }
        let _e214 = local;
        clusters.member[_e47] = type_24(vec4<u32>(bitcast<u32>(_e214.member[0]), bitcast<u32>(_e214.member[1]), bitcast<u32>(_e214.member[2]), ((_e54 - 1u) + _e47)), vec4<u32>(bitcast<u32>(_e214.member_1[0]), bitcast<u32>(_e214.member_1[1]), bitcast<u32>(_e214.member_1[2]), 1u));
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
