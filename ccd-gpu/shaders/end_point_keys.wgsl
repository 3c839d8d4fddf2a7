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
    var phi_93_: u32;
    var phi_94_: u32;
    var phi_132_: f32;
    var phi_133_: f32;
    var phi_139_: u32;
    var phi_149_: u32;
    var phi_161_: f32;
    var phi_162_: f32;
    var phi_168_: u32;
    var phi_178_: u32;
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
            if (_e32 >= _e44) {
                phi_93_ = 1u;
            } else {
                phi_93_ = 0u;
            }
            let _e47 = phi_93_;
            phi_94_ = _e47;
        }
        let _e49 = phi_94_;
        let _e51 = survey.member[6u];
        let _e53 = boxes.member[_e32];
        let _e69 = (select(0u, 1u, (_e49 == 1u)) << bitcast<u32>(31i));
        if (_e51 == 0u) {
            phi_133_ = _e53.member.x;
        } else {
            if (_e51 == 1u) {
                phi_132_ = _e53.member.y;
            } else {
                phi_132_ = _e53.member_1.x;
            }
            let _e73 = phi_132_;
            phi_133_ = _e73;
        }
        let _e75 = phi_133_;
        let _e76 = bitcast<u32>(_e75);
        if (_e76 == 2147483648u) {
            phi_139_ = 0u;
        } else {
            phi_139_ = _e76;
        }
        let _e79 = phi_139_;
        let _e81 = bitcast<u32>(bitcast<f32>(_e79));
        if ((_e81 >> bitcast<u32>(31i)) == 1u) {
            phi_149_ = ~(_e81);
        } else {
            phi_149_ = (_e81 | 2147483648u);
        }
        let _e88 = phi_149_;
        if (_e51 == 0u) {
            phi_162_ = _e53.member_1.y;
        } else {
            if (_e51 == 1u) {
                phi_161_ = _e53.member_2.x;
            } else {
                phi_161_ = _e53.member_2.y;
            }
            let _e97 = phi_161_;
            phi_162_ = _e97;
        }
        let _e99 = phi_162_;
        let _e100 = bitcast<u32>(_e99);
        if (_e100 == 2147483648u) {
            phi_168_ = 0u;
        } else {
            phi_168_ = _e100;
        }
        let _e103 = phi_168_;
        let _e105 = bitcast<u32>(bitcast<f32>(_e103));
        if ((_e105 >> bitcast<u32>(31i)) == 1u) {
            phi_178_ = ~(_e105);
        } else {
            phi_178_ = (_e105 | 2147483648u);
        }
        let _e112 = phi_178_;
        let _e120 = (_e32 << bitcast<u32>(1i));
        let _e123 = ((_e32 << bitcast<u32>(1i)) | 1u);
        keys.member[_e120] = (_e69 | ((_e88 >> bitcast<u32>(2i)) << bitcast<u32>(1i)));
        keys.member[_e123] = ((_e69 | ((_e112 >> bitcast<u32>(2i)) << bitcast<u32>(1i))) | 1u);
        points.member[_e120] = _e120;
        points.member[_e123] = _e123;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn end_point_keys(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
