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
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<vec4<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(2) 
var<storage> elements: type_10;
@group(0) @binding(1) 
var<storage> order: type_10;
@group(0) @binding(3) 
var<storage, read_write> leaves: type_18;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_92_: u32;
    var phi_220_: array<u32, 3>;
    var phi_222_: type_16;
    var phi_223_: type_16;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = n_2;
    let _e16 = lane_2;
    let _e27 = ((((_e14.y * _e15.x) + _e14.x) * 256u) + _e16);
    let _e32 = params.member.member_2.member[0u][3u];
    if (_e27 < _e32) {
        let _e38 = params.member.member_2.member[0u][2u];
        if (_e27 >= _e38) {
            phi_92_ = 2u;
        } else {
            let _e41 = params.member.member_2.member[0u][1u];
            phi_92_ = select(0u, 1u, (_e27 >= _e41));
        }
        let _e45 = phi_92_;
        let _e50 = params.member.member_2.member[0u][_e45];
        let _e51 = (_e27 - _e50);
        let _e55 = params.member.member.member[_e45];
        if (_e51 < _e55) {
            let _e60 = params.member.member.member_2[_e45];
            let _e63 = order.member[(_e60 + _e51)];
            let _e67 = params.member.member.member_2[_e45];
            let _e68 = (_e63 - _e67);
            let _e72 = type_16(array<u32, 3>(_e68, _e68, _e68), type_16(array<u32, 3>(0u, 0u, 0u), _e68).member_1);
            if (_e45 > 0u) {
                let _e77 = params.member.member.member_2[1u];
                let _e78 = (_e63 - _e77);
                let _e82 = params.member.member.member[1u];
                if (_e78 < _e82) {
                    let _e97 = (2u * _e78);
                    let _e99 = elements.member[_e97];
                    let _e102 = elements.member[(_e97 + 1u)];
                    phi_220_ = array<u32, 3>(_e99, _e102, _e102);
                } else {
                    let _e87 = ((2u * _e82) + (3u * (_e78 - _e82)));
                    let _e89 = elements.member[_e87];
                    let _e92 = elements.member[(_e87 + 1u)];
                    let _e95 = elements.member[(_e87 + 2u)];
                    phi_220_ = array<u32, 3>(_e89, _e92, _e95);
                }
                let _e105 = phi_220_;
                phi_222_ = type_16(_e105, _e72.member_1);
            } else {
                phi_222_ = _e72;
            }
            let _e109 = phi_222_;
            phi_223_ = _e109;
        } else {
            phi_223_ = type_16(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        }
        let _e111 = phi_223_;
        leaves.member[_e27] = vec4<u32>(_e111.member[0], _e111.member[1], _e111.member[2], _e111.member_1);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
