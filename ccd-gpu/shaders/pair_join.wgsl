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

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: array<vec4<u32>>,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_19 {
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_21 {
    member: array<type_19>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> clusters: type_21;
@group(0) @binding(2) 
var<storage> items: type_13;
@group(0) @binding(3) 
var<storage, read_write> clusters_out: type_21;
@group(0) @binding(4) 
var<storage, read_write> items_out: type_13;
@group(0) @binding(5) 
var<storage, read_write> joins: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_103_: u32;
    var phi_246_: f32;
    var phi_251_: f32;
    var phi_256_: f32;
    var phi_262_: f32;
    var phi_267_: f32;
    var phi_272_: f32;
    var phi_276_: type_15;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e16 = id_2;
    let _e17 = n_2;
    let _e18 = lane_2;
    let _e31 = ((((_e16.y * _e17.x) + _e16.x) * 256u) + _e18);
    let _e34 = params.member.member_1.member;
    let _e35 = (_e34 / 2u);
    if ((_e34 % 2u) > 0u) {
        phi_103_ = (_e35 + 1u);
    } else {
        phi_103_ = _e35;
    }
    let _e40 = phi_103_;
    if (_e31 < _e40) {
        let _e44 = items.member[(2u * _e31)];
        let _e47 = clusters.member[_e44.w];
        let _e50 = bitcast<f32>(_e47.member.x);
        let _e52 = bitcast<f32>(_e47.member.y);
        let _e54 = bitcast<f32>(_e47.member.z);
        let _e60 = bitcast<f32>(_e47.member_1.x);
        let _e62 = bitcast<f32>(_e47.member_1.y);
        let _e64 = bitcast<f32>(_e47.member_1.z);
        if (((2u * _e31) + 1u) < _e34) {
            let _e75 = items.member[((2u * _e31) + 1u)];
            let _e78 = clusters.member[_e75.w];
            let _e81 = bitcast<f32>(_e78.member.x);
            let _e83 = bitcast<f32>(_e78.member.y);
            let _e85 = bitcast<f32>(_e78.member.z);
            let _e90 = bitcast<f32>(_e78.member_1.x);
            let _e92 = bitcast<f32>(_e78.member_1.y);
            let _e94 = bitcast<f32>(_e78.member_1.z);
            let _e99 = params.member.member_2.member_4;
            let _e100 = (_e99 + _e31);
            let _e101 = (_e100 * 4u);
            let _e102 = (_e47.member.w * 4u);
            let _e103 = (_e78.member.w * 4u);
            joins.member[_e102] = _e100;
            joins.member[(_e102 + 1u)] = 0u;
            joins.member[_e103] = _e100;
            joins.member[(_e103 + 1u)] = _e47.member_1.w;
            joins.member[(_e101 + 2u)] = _e47.member_1.w;
            joins.member[(_e101 + 3u)] = (_e47.member_1.w + _e78.member_1.w);
            if (_e50 < _e81) {
                phi_246_ = _e50;
            } else {
                phi_246_ = _e81;
            }
            let _e117 = phi_246_;
            if (_e52 < _e83) {
                phi_251_ = _e52;
            } else {
                phi_251_ = _e83;
            }
            let _e120 = phi_251_;
            if (_e54 < _e85) {
                phi_256_ = _e54;
            } else {
                phi_256_ = _e85;
            }
            let _e123 = phi_256_;
            if (_e60 > _e90) {
                phi_262_ = _e60;
            } else {
                phi_262_ = _e90;
            }
            let _e127 = phi_262_;
            if (_e62 > _e92) {
                phi_267_ = _e62;
            } else {
                phi_267_ = _e92;
            }
            let _e130 = phi_267_;
            if (_e64 > _e94) {
                phi_272_ = _e64;
            } else {
                phi_272_ = _e94;
            }
            let _e133 = phi_272_;
            phi_276_ = type_15(array<f32, 3>(_e117, _e120, _e123), _e100, array<f32, 3>(_e127, _e130, _e133), (_e47.member_1.w + _e78.member_1.w));
        } else {
            phi_276_ = type_15(array<f32, 3>(_e50, _e52, _e54), _e47.member.w, array<f32, 3>(_e60, _e62, _e64), _e47.member_1.w);
        }
        let _e138 = phi_276_;
        clusters_out.member[_e31] = type_19(vec4<u32>(bitcast<u32>(_e138.member[0]), bitcast<u32>(_e138.member[1]), bitcast<u32>(_e138.member[2]), _e138.member_1), vec4<u32>(bitcast<u32>(_e138.member_2[0]), bitcast<u32>(_e138.member_2[1]), bitcast<u32>(_e138.member_2[2]), _e138.member_3));
        items_out.member[_e31] = vec4<u32>(bitcast<u32>((_e138.member[0] + _e138.member_2[0])), bitcast<u32>((_e138.member[1] + _e138.member_2[1])), bitcast<u32>((_e138.member[2] + _e138.member_2[2])), _e31);
        if (_e40 == 1u) {
            let _e177 = (_e138.member_1 * 4u);
            joins.member[_e177] = 4294967295u;
            joins.member[(_e177 + 1u)] = 0u;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_join(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
