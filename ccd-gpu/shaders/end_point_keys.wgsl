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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_15 {
    member: array<type_13>,
}

struct type_16 {
    member: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> survey: type_10;
@group(0) @binding(3) 
var<storage, read_write> keys: type_10;
@group(0) @binding(1) 
var<storage> boxes: type_15;
@group(0) @binding(4) 
var<storage, read_write> points: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_94_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e18 = id_2;
    let _e19 = n_2;
    let _e20 = lane_2;
    let _e32 = ((((_e18.y * _e19.x) + _e18.x) * 256u) + _e20);
    let _e36 = params.member.member.member_2[3u];
    if (_e32 < _e36) {
        let _e41 = params.member.member.member_2[2u];
        if (_e32 >= _e41) {
            phi_94_ = 2u;
        } else {
            let _e44 = params.member.member.member_2[1u];
            phi_94_ = select(0u, 1u, (_e32 >= _e44));
        }
        let _e48 = phi_94_;
        let _e50 = survey.member[6u];
        let _e52 = boxes.member[_e32];
        let _e68 = (select(0u, 1u, (_e48 == 1u)) << bitcast<u32>(31i));
        let _e73 = bitcast<u32>(select(select(_e52.member_1.x, _e52.member.y, (_e50 == 1u)), _e52.member.x, (_e50 == 0u)));
        let _e77 = bitcast<u32>(bitcast<f32>(select(_e73, 0u, (_e73 == 2147483648u))));
        let _e93 = bitcast<u32>(select(select(_e52.member_2.y, _e52.member_2.x, (_e50 == 1u)), _e52.member_1.y, (_e50 == 0u)));
        let _e97 = bitcast<u32>(bitcast<f32>(select(_e93, 0u, (_e93 == 2147483648u))));
        let _e111 = (_e32 << bitcast<u32>(1i));
        let _e114 = ((_e32 << bitcast<u32>(1i)) | 1u);
        keys.member[_e111] = (_e68 | ((select((_e77 | 2147483648u), ~(_e77), ((_e77 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i)) << bitcast<u32>(1i)));
        keys.member[_e114] = ((_e68 | ((select((_e97 | 2147483648u), ~(_e97), ((_e97 >> bitcast<u32>(31i)) == 1u)) >> bitcast<u32>(2i)) << bitcast<u32>(1i))) | 1u);
        points.member[_e111] = _e111;
        points.member[_e114] = _e114;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn end_point_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
