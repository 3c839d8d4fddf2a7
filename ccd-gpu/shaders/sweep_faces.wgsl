struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: array<array<u32, 3>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_13;
@group(0) @binding(1) 
var<storage> faces: type_15;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_107_: f32;
    var phi_114_: f32;
    var phi_121_: f32;
    var phi_128_: f32;
    var phi_135_: f32;
    var phi_142_: f32;
    var phi_158_: f32;
    var phi_164_: f32;
    var phi_170_: f32;
    var phi_177_: f32;
    var phi_183_: f32;
    var phi_189_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e8 = id_2;
    let _e9 = n_2;
    let _e10 = lane_2;
    let _e20 = ((((_e8.y * _e9.x) + _e8.x) * 256u) + _e10);
    let _e23 = params.member.member[2u];
    if (_e20 < _e23) {
        let _e26 = faces.member[_e20];
        let _e31 = boxes.member[_e26[0]];
        let _e33 = boxes.member[_e26[1]];
        if (_e31.member[0] < _e33.member[0]) {
            phi_107_ = _e31.member[0];
        } else {
            phi_107_ = _e33.member[0];
        }
        let _e40 = phi_107_;
        if (_e31.member[1] < _e33.member[1]) {
            phi_114_ = _e31.member[1];
        } else {
            phi_114_ = _e33.member[1];
        }
        let _e47 = phi_114_;
        if (_e31.member[2] < _e33.member[2]) {
            phi_121_ = _e31.member[2];
        } else {
            phi_121_ = _e33.member[2];
        }
        let _e54 = phi_121_;
        if (_e31.member_1[0] > _e33.member_1[0]) {
            phi_128_ = _e31.member_1[0];
        } else {
            phi_128_ = _e33.member_1[0];
        }
        let _e61 = phi_128_;
        if (_e31.member_1[1] > _e33.member_1[1]) {
            phi_135_ = _e31.member_1[1];
        } else {
            phi_135_ = _e33.member_1[1];
        }
        let _e68 = phi_135_;
        if (_e31.member_1[2] > _e33.member_1[2]) {
            phi_142_ = _e31.member_1[2];
        } else {
            phi_142_ = _e33.member_1[2];
        }
        let _e75 = phi_142_;
        let _e77 = boxes.member[_e26[2]];
        if (_e40 < _e77.member[0]) {
            phi_158_ = _e40;
        } else {
            phi_158_ = _e77.member[0];
        }
        let _e82 = phi_158_;
        if (_e47 < _e77.member[1]) {
            phi_164_ = _e47;
        } else {
            phi_164_ = _e77.member[1];
        }
        let _e87 = phi_164_;
        if (_e54 < _e77.member[2]) {
            phi_170_ = _e54;
        } else {
            phi_170_ = _e77.member[2];
        }
        let _e92 = phi_170_;
        if (_e61 > _e77.member_1[0]) {
            phi_177_ = _e61;
        } else {
            phi_177_ = _e77.member_1[0];
        }
        let _e98 = phi_177_;
        if (_e68 > _e77.member_1[1]) {
            phi_183_ = _e68;
        } else {
            phi_183_ = _e77.member_1[1];
        }
        let _e103 = phi_183_;
        if (_e75 > _e77.member_1[2]) {
            phi_189_ = _e75;
        } else {
            phi_189_ = _e77.member_1[2];
        }
        let _e108 = phi_189_;
        let _e113 = params.member.member_2[2u];
        boxes.member[(_e113 + _e20)] = type_11(array<f32, 3>(_e82, _e87, _e92), array<f32, 3>(_e98, _e103, _e108));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_faces(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
