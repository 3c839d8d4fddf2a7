struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
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

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_23 {
    member: array<array<u32, 2>>,
}

struct type_31 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> edges: type_23;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_19;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var phi_136_: type_31;
    var phi_137_: type_31;
    var phi_160_: type_31;
    var phi_186_: f32;
    var phi_213_: f32;

    let _e18 = id_1;
    let _e19 = n_1;
    let _e20 = lane_1;
    let _e30 = ((((_e18.y * _e19.x) + _e18.x) * 256u) + _e20);
    let _e33 = params.member.member[1u];
    if (_e30 < _e33) {
        let _e36 = edges.member[_e30];
        let _e40 = boxes.member[_e36[0]];
        let _e42 = boxes.member[_e36[1]];
        local_1 = type_6(array<f32, 3>(_e42.member[0], _e42.member[1], _e42.member[2]), array<f32, 3>(_e42.member_1[0], _e42.member_1[1], _e42.member_1[2]));
        local = type_6(array<f32, 3>(_e40.member[0], _e40.member[1], _e40.member[2]), array<f32, 3>(_e40.member_1[0], _e40.member_1[1], _e40.member_1[2]));
        phi_136_ = type_31(0u, 3u);
        loop {
            let _e66 = phi_136_;
            if (_e66.member < _e66.member_1) {
                phi_137_ = type_31((_e66.member + 1u), _e66.member_1);
                phi_160_ = type_31(1u, _e66.member);
            } else {
                phi_137_ = _e66;
                phi_160_ = type_31(0u, type_31().member_1);
            }
            let _e80 = phi_137_;
            let _e82 = phi_160_;
            let _e86 = (bitcast<i32>(_e82.member) != 0i);
            if _e86 {
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e90 = local.member[_e82.member_1];
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e94 = local_1.member[_e82.member_1];
                if (_e90 < _e94) {
                    phi_186_ = _e90;
                } else {
                    phi_186_ = _e94;
                }
                let _e97 = phi_186_;
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                local.member[_e82.member_1] = _e97;
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e104 = local.member_1[_e82.member_1];
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                let _e108 = local_1.member_1[_e82.member_1];
                if (_e104 > _e108) {
                    phi_213_ = _e104;
                } else {
                    phi_213_ = _e108;
                }
                let _e111 = phi_213_;
                if (_e82.member_1 < 3u) {
                } else {
                    return;
                }
                local.member_1[_e82.member_1] = _e111;
            }
            continue;
            continuing {
                phi_136_ = _e80;
                break if !(_e86);
            }
        }
        let _e116 = local;
        let _e130 = params.member.member_2[1u];
        boxes.member[(_e130 + _e30)] = type_6(array<f32, 3>(_e116.member[0], _e116.member[1], _e116.member[2]), array<f32, 3>(_e116.member_1[0], _e116.member_1[1], _e116.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_edges(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
