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
    let _e39 = select(_e35, (_e35 + 1u), ((_e34 % 2u) > 0u));
    if (_e31 < _e39) {
        let _e43 = items.member[(2u * _e31)];
        let _e46 = clusters.member[_e43.w];
        let _e49 = bitcast<f32>(_e46.member.x);
        let _e51 = bitcast<f32>(_e46.member.y);
        let _e53 = bitcast<f32>(_e46.member.z);
        let _e59 = bitcast<f32>(_e46.member_1.x);
        let _e61 = bitcast<f32>(_e46.member_1.y);
        let _e63 = bitcast<f32>(_e46.member_1.z);
        if (((2u * _e31) + 1u) < _e34) {
            let _e74 = items.member[((2u * _e31) + 1u)];
            let _e77 = clusters.member[_e74.w];
            let _e80 = bitcast<f32>(_e77.member.x);
            let _e82 = bitcast<f32>(_e77.member.y);
            let _e84 = bitcast<f32>(_e77.member.z);
            let _e89 = bitcast<f32>(_e77.member_1.x);
            let _e91 = bitcast<f32>(_e77.member_1.y);
            let _e93 = bitcast<f32>(_e77.member_1.z);
            let _e98 = params.member.member_2.member_4;
            let _e99 = (_e98 + _e31);
            let _e100 = (_e99 * 4u);
            let _e101 = (_e46.member.w * 4u);
            let _e102 = (_e77.member.w * 4u);
            joins.member[_e101] = _e99;
            joins.member[(_e101 + 1u)] = 0u;
            joins.member[_e102] = _e99;
            joins.member[(_e102 + 1u)] = _e46.member_1.w;
            joins.member[(_e100 + 2u)] = _e46.member_1.w;
            joins.member[(_e100 + 3u)] = (_e46.member_1.w + _e77.member_1.w);
            phi_276_ = type_15(array<f32, 3>(select(_e80, _e49, (_e49 < _e80)), select(_e82, _e51, (_e51 < _e82)), select(_e84, _e53, (_e53 < _e84))), _e99, array<f32, 3>(select(_e89, _e59, (_e59 > _e89)), select(_e91, _e61, (_e61 > _e91)), select(_e93, _e63, (_e63 > _e93))), (_e46.member_1.w + _e77.member_1.w));
        } else {
            phi_276_ = type_15(array<f32, 3>(_e49, _e51, _e53), _e46.member.w, array<f32, 3>(_e59, _e61, _e63), _e46.member_1.w);
        }
        let _e131 = phi_276_;
        clusters_out.member[_e31] = type_19(vec4<u32>(bitcast<u32>(_e131.member[0]), bitcast<u32>(_e131.member[1]), bitcast<u32>(_e131.member[2]), _e131.member_1), vec4<u32>(bitcast<u32>(_e131.member_2[0]), bitcast<u32>(_e131.member_2[1]), bitcast<u32>(_e131.member_2[2]), _e131.member_3));
        items_out.member[_e31] = vec4<u32>(bitcast<u32>((_e131.member[0] + _e131.member_2[0])), bitcast<u32>((_e131.member[1] + _e131.member_2[1])), bitcast<u32>((_e131.member[2] + _e131.member_2[2])), _e31);
        if (_e39 == 1u) {
            let _e170 = (_e131.member_1 * 4u);
            joins.member[_e170] = 4294967295u;
            joins.member[(_e170 + 1u)] = 0u;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_join(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
