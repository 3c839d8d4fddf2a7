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

struct type_11 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_12 {
    member: type_7,
    member_1: type_8,
    member_2: type_11,
}

struct type_13 {
    member: type_12,
}

struct type_17 {
    member: array<vec4<u32>>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: array<vec4<f32>>,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_25 {
    member: array<type_23>,
}

@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> leaves: type_17;
@group(0) @binding(2) 
var<storage> paths: type_25;
@group(0) @binding(3) 
var<storage, read_write> ends: type_22;

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: f32, param_3: f32) -> f32 {
    return select(param_2, param_3, select((param_3 <= param_2), true, (param_2 != param_2)));
}

fn function_2(param_4: array<f32, 4>, param_5: array<f32, 4>, param_6: array<f32, 4>) -> type_19 {
    let _e9 = function_1(param_4[0], param_5[0]);
    let _e10 = function_1(param_4[1], param_5[1]);
    let _e11 = function_1(param_4[2], param_5[2]);
    let _e12 = function_(param_4[0], param_5[0]);
    let _e13 = function_(param_4[1], param_5[1]);
    let _e14 = function_(param_4[2], param_5[2]);
    let _e18 = function_1(_e9, param_6[0]);
    let _e19 = function_1(_e10, param_6[1]);
    let _e20 = function_1(_e11, param_6[2]);
    let _e22 = function_(_e9, param_6[0]);
    let _e23 = function_(_e10, param_6[1]);
    let _e24 = function_(_e11, param_6[2]);
    let _e28 = function_1(_e12, param_6[0]);
    let _e29 = function_1(_e13, param_6[1]);
    let _e30 = function_1(_e14, param_6[2]);
    let _e31 = function_(_e12, param_6[0]);
    let _e32 = function_(_e13, param_6[1]);
    let _e33 = function_(_e14, param_6[2]);
    return type_19(array<f32, 3>(_e18, _e19, _e20), array<f32, 3>(_e31, _e32, _e33));
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e15 = id_2;
    let _e16 = n_2;
    let _e17 = lane_2;
    let _e28 = ((((_e15.y * _e16.x) + _e15.x) * 256u) + _e17);
    let _e33 = params.member.member_2.member[0u][3u];
    if (_e28 < _e33) {
        let _e36 = leaves.member[_e28];
        if (_e36.w != 4294967295u) {
            let _e43 = paths.member[_e36.x];
            let _e63 = paths.member[_e36.y];
            let _e83 = paths.member[_e36.z];
            let _e102 = function_2(array<f32, 4>(_e43.member.x, _e43.member.y, _e43.member.z, _e43.member.w), array<f32, 4>(_e63.member.x, _e63.member.y, _e63.member.z, _e63.member.w), array<f32, 4>(_e83.member.x, _e83.member.y, _e83.member.z, _e83.member.w));
            let _e103 = function_2(array<f32, 4>(_e43.member_1.x, _e43.member_1.y, _e43.member_1.z, _e43.member_1.w), array<f32, 4>(_e63.member_1.x, _e63.member_1.y, _e63.member_1.z, _e63.member_1.w), array<f32, 4>(_e83.member_1.x, _e83.member_1.y, _e83.member_1.z, _e83.member_1.w));
            ends.member[(((_e28 / 32u) * 96u) + (_e28 % 32u))] = vec4<f32>(_e102.member[0], _e102.member[1], _e102.member[2], _e102.member_1[0]);
            ends.member[(((((_e28 / 32u) * 3u) + 1u) * 32u) + (_e28 % 32u))] = vec4<f32>(_e102.member_1[1], _e102.member_1[2], _e103.member[0], _e103.member[1]);
            ends.member[(((((_e28 / 32u) * 3u) + 2u) * 32u) + (_e28 % 32u))] = vec4<f32>(_e103.member[2], _e103.member_1[0], _e103.member_1[1], _e103.member_1[2]);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_ends(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
