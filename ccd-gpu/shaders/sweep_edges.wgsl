struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_10 {
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

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
}

struct type_15 {
    member: array<array<u32, 2>>,
}

struct type_17 {
    member: u32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> edges: type_15;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var phi_136_: type_17;
    var phi_137_: type_17;
    var phi_160_: type_17;
    var phi_186_: f32;
    var phi_213_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = n_2;
    let _e16 = lane_2;
    let _e26 = ((((_e14.y * _e15.x) + _e14.x) * 256u) + _e16);
    let _e29 = params.member.member[1u];
    if (_e26 < _e29) {
        let _e32 = edges.member[_e26];
        let _e36 = boxes.member[_e32[0]];
        let _e38 = boxes.member[_e32[1]];
        local_1 = type_4(array<f32, 3>(_e38.member[0], _e38.member[1], _e38.member[2]), array<f32, 3>(_e38.member_1[0], _e38.member_1[1], _e38.member_1[2]));
        local = type_4(array<f32, 3>(_e36.member[0], _e36.member[1], _e36.member[2]), array<f32, 3>(_e36.member_1[0], _e36.member_1[1], _e36.member_1[2]));
        phi_136_ = type_17(0u, 3u);
        loop {
            let _e62 = phi_136_;
            if (_e62.member < _e62.member_1) {
                phi_137_ = type_17((_e62.member + 1u), _e62.member_1);
                phi_160_ = type_17(1u, _e62.member);
            } else {
                phi_137_ = _e62;
                phi_160_ = type_17(0u, type_17().member_1);
            }
            let _e74 = phi_137_;
            let _e76 = phi_160_;
            let _e80 = (bitcast<i32>(_e76.member) != 0i);
            if _e80 {
                let _e83 = local.member[_e76.member_1];
                let _e86 = local_1.member[_e76.member_1];
                if (_e83 < _e86) {
                    phi_186_ = _e83;
                } else {
                    phi_186_ = _e86;
                }
                let _e89 = phi_186_;
                local.member[_e76.member_1] = _e89;
                let _e94 = local.member_1[_e76.member_1];
                let _e97 = local_1.member_1[_e76.member_1];
                if (_e94 > _e97) {
                    phi_213_ = _e94;
                } else {
                    phi_213_ = _e97;
                }
                let _e100 = phi_213_;
                local.member_1[_e76.member_1] = _e100;
            }
            continue;
            continuing {
                phi_136_ = _e74;
                break if !(_e80);
            }
        }
        let _e104 = local;
        let _e118 = params.member.member_2[1u];
        boxes.member[(_e118 + _e26)] = type_4(array<f32, 3>(_e104.member[0], _e104.member[1], _e104.member[2]), array<f32, 3>(_e104.member_1[0], _e104.member_1[1], _e104.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_edges(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
