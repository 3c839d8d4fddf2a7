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
    member: i32,
    member_1: i32,
}

struct type_14 {
    member: u32,
    member_1: i32,
}

struct type_16 {
    member: array<array<u32, 4>, 8>,
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

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> order: type_10;
@group(0) @binding(1) 
var<storage> boxes: type_22;
var<workgroup> shared_: array<type_24, 256>;
@group(0) @binding(3) 
var<storage, read_write> nodes: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 4>;
    var phi_125_: u32;
    var phi_186_: type_24;
    var phi_187_: type_24;
    var phi_202_: type_13;
    var phi_205_: type_24;
    var phi_207_: u32;
    var phi_203_: type_13;
    var phi_248_: type_14;
    var phi_460_: type_24;
    var phi_206_: type_24;
    var phi_208_: u32;
    var local_1: type_24;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: type_24;
    var local_6: type_24;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e25 = id_2;
    let _e26 = n_2;
    let _e27 = lane_2;
    let _e40 = params.member.member_2.member[0u];
    local = array<u32, 4>(_e40[0], _e40[1], _e40[2], _e40[3]);
    let _e47 = ((((_e25.y * _e26.x) + _e25.x) * 256u) + _e27);
    let _e49 = local[3u];
    let _e50 = (_e47 < _e49);
    let _e52 = local[2u];
    if (_e47 >= _e52) {
        phi_125_ = 2u;
    } else {
        let _e55 = local[1u];
        phi_125_ = select(0u, 1u, (_e47 >= _e55));
    }
    let _e59 = phi_125_;
    let _e61 = local[_e59];
    let _e62 = (_e47 - _e61);
    if _e50 {
        let _e66 = params.member.member.member[_e59];
        if (_e62 < _e66) {
            let _e71 = params.member.member.member_2[_e59];
            let _e74 = order.member[(_e71 + _e62)];
            let _e76 = boxes.member[_e74];
            phi_186_ = type_24(array<f32, 3>(_e76.member.x, _e76.member.y, _e76.member_1.x), array<f32, 3>(_e76.member_1.y, _e76.member_2.x, _e76.member_2.y));
        } else {
            phi_186_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e93 = phi_186_;
        phi_187_ = _e93;
    } else {
        phi_187_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e95 = phi_187_;
    shared_[_e27] = type_24(array<f32, 3>(_e95.member[0], _e95.member[1], _e95.member[2]), array<f32, 3>(_e95.member_1[0], _e95.member_1[1], _e95.member_1[2]));
    phi_202_ = type_13(0i, 5i);
    phi_205_ = _e95;
    phi_207_ = 16u;
    loop {
        let _e109 = phi_202_;
        let _e111 = phi_205_;
        let _e113 = phi_207_;
        local_1 = _e111;
        local_2 = _e111;
        local_3 = _e111;
        local_4 = _e111;
        local_5 = _e111;
        local_6 = _e111;
        if (_e109.member < _e109.member_1) {
            let _e120 = (_e109.member + 1i);
            phi_203_ = type_13(select(_e120, type_14().member_1, select(false, true, ((false == (_e120 > _e109.member)) != false))), _e109.member_1);
            phi_248_ = type_14(1u, _e109.member);
        } else {
            phi_203_ = _e109;
            phi_248_ = type_14(0u, type_14().member_1);
        }
        let _e131 = phi_203_;
        let _e133 = phi_248_;
        let _e136 = (bitcast<i32>(_e133.member) != 0i);
        if _e136 {
            workgroupBarrier();
            if ((_e27 % 32u) < _e113) {
                let _e141 = shared_[(_e27 + _e113)];
                let _e153 = select(_e141.member[0], _e111.member[0], (_e111.member[0] < _e141.member[0]));
                let _e157 = select(_e141.member[1], _e111.member[1], (_e111.member[1] < _e141.member[1]));
                let _e161 = select(_e141.member[2], _e111.member[2], (_e111.member[2] < _e141.member[2]));
                let _e166 = select(_e141.member_1[0], _e111.member_1[0], (_e111.member_1[0] > _e141.member_1[0]));
                let _e170 = select(_e141.member_1[1], _e111.member_1[1], (_e111.member_1[1] > _e141.member_1[1]));
                let _e174 = select(_e141.member_1[2], _e111.member_1[2], (_e111.member_1[2] > _e141.member_1[2]));
                shared_[_e27] = type_24(array<f32, 3>(_e153, _e157, _e161), array<f32, 3>(_e166, _e170, _e174));
                phi_460_ = type_24(array<f32, 3>(_e153, _e157, _e161), array<f32, 3>(_e166, _e170, _e174));
            } else {
                phi_460_ = _e111;
            }
            let _e182 = phi_460_;
            phi_206_ = _e182;
            phi_208_ = (_e113 / 2u);
        } else {
            phi_206_ = type_24();
            phi_208_ = u32();
        }
        let _e185 = phi_206_;
        let _e187 = phi_208_;
        continue;
        continuing {
            phi_202_ = _e131;
            phi_205_ = _e185;
            phi_207_ = _e187;
            break if !(_e136);
        }
    }
    if _e50 {
        nodes.member[_e47] = type_20(vec2<f32>(_e95.member[0], _e95.member[1]), vec2<f32>(_e95.member[2], _e95.member_1[0]), vec2<f32>(_e95.member_1[1], _e95.member_1[2]));
        if ((_e27 % 32u) == 0u) {
            let _e213 = params.member.member_2.member[1u][_e59];
            let _e216 = local_1;
            let _e220 = local_2;
            let _e224 = local_3;
            let _e228 = local_4;
            let _e232 = local_5;
            let _e236 = local_6;
            nodes.member[(_e213 + (_e62 / 32u))] = type_20(vec2<f32>(_e216.member[0], _e220.member[1]), vec2<f32>(_e224.member[2], _e228.member_1[0]), vec2<f32>(_e232.member_1[1], _e236.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
