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

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: f32,
    member_1: f32,
}

struct type_14 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_16 {
    member: array<type_14>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_21 {
    member: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

@group(0) @binding(1) 
var<storage> paths: type_16;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(2) 
var<storage, read_write> boxes: type_20;

fn function_(param: f32) -> type_12 {
    return type_12(param, param);
}

fn function_1(param_1: f32) -> type_12 {
    return type_12(param_1, param_1);
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_18;
    var local_1: type_18;
    var local_2: type_18;
    var phi_172_: type_9;
    var phi_332_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e21 = id_2;
    let _e22 = n_2;
    let _e23 = lane_2;
    let _e33 = ((((_e21.y * _e22.x) + _e21.x) * 256u) + _e23);
    let _e37 = params.member.member.member[0u];
    if (_e33 < _e37) {
        let _e40 = paths.member[_e33];
        let _e43 = params.member.member.member_3;
        let _e53 = select(_e40.member_1[0], _e40.member[0], (_e40.member[0] < _e40.member_1[0]));
        let _e55 = select(_e40.member_1[1], _e40.member[1], (_e40.member[1] < _e40.member_1[1]));
        let _e57 = select(_e40.member_1[2], _e40.member[2], (_e40.member[2] < _e40.member_1[2]));
        let _e59 = select(_e40.member_1[0], _e40.member[0], (_e40.member[0] > _e40.member_1[0]));
        let _e61 = select(_e40.member_1[1], _e40.member[1], (_e40.member[1] > _e40.member_1[1]));
        let _e63 = select(_e40.member_1[2], _e40.member[2], (_e40.member[2] > _e40.member_1[2]));
        if (_e43 > 0f) {
            local_1 = type_18(array<f32, 3>(_e53, _e55, _e57), array<f32, 3>(_e59, _e61, _e63));
            phi_172_ = type_9(0u, 3u);
            loop {
                let _e72 = phi_172_;
                let _e75 = (_e72.member < _e72.member_1);
                let _e86 = select(type_9().member_1, _e72.member, _e75);
                let _e88 = (bitcast<i32>(select(0u, 1u, _e75)) != 0i);
                if _e88 {
                    let _e91 = local_1.member[_e86];
                    let _e93 = -((_e91 - _e43));
                    let _e94 = bitcast<u32>(_e93);
                    local_1.member[_e86] = -(select(_e93, select(select(0.000000000000000000000000000000000000000000001f, bitcast<f32>((_e94 - 1u)), (_e93 < 0f)), bitcast<f32>((_e94 + 1u)), (_e93 > 0f)), select(true, (_e93 < 0f), ((_e94 & 2139095040u) == 2139095040u))));
                    let _e113 = local_1.member_1[_e86];
                    let _e114 = (_e113 + _e43);
                    let _e115 = bitcast<u32>(_e114);
                    local_1.member_1[_e86] = select(_e114, select(select(0.000000000000000000000000000000000000000000001f, bitcast<f32>((_e115 - 1u)), (_e114 < 0f)), bitcast<f32>((_e115 + 1u)), (_e114 > 0f)), select(true, (_e114 < 0f), ((_e115 & 2139095040u) == 2139095040u)));
                }
                continue;
                continuing {
                    phi_172_ = type_9(select(_e72.member, (_e72.member + 1u), _e75), select(_e72.member_1, _e72.member_1, _e75));
                    break if !(_e88);
                }
            }
        } else {
            local_1 = type_18(array<f32, 3>(_e53, _e55, _e57), array<f32, 3>(_e59, _e61, _e63));
        }
        let _e132 = local_1;
        local_2 = _e132;
        local = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_332_ = type_9(0u, 3u);
        loop {
            let _e134 = phi_332_;
            let _e137 = (_e134.member < _e134.member_1);
            let _e148 = select(type_9().member_1, _e134.member, _e137);
            let _e150 = (bitcast<i32>(select(0u, 1u, _e137)) != 0i);
            if _e150 {
                let _e153 = local_2.member[_e148];
                let _e154 = function_(_e153);
                let _e156 = -(290000000000000000000000000000000000000f);
                let _e158 = select(_e156, _e154.member, (_e154.member > _e156));
                local.member[_e148] = select(290000000000000000000000000000000000000f, _e158, (_e158 < 290000000000000000000000000000000000000f));
                let _e165 = local_2.member_1[_e148];
                let _e166 = function_1(_e165);
                let _e168 = -(290000000000000000000000000000000000000f);
                let _e170 = select(_e168, _e166.member_1, (_e166.member_1 > _e168));
                local.member_1[_e148] = select(290000000000000000000000000000000000000f, _e170, (_e170 < 290000000000000000000000000000000000000f));
            }
            continue;
            continuing {
                phi_332_ = type_9(select(_e134.member, (_e134.member + 1u), _e137), select(_e134.member_1, _e134.member_1, _e137));
                break if !(_e150);
            }
        }
        let _e176 = local;
        boxes.member[_e33] = type_18(array<f32, 3>(_e176.member[0], _e176.member[1], _e176.member[2]), array<f32, 3>(_e176.member_1[0], _e176.member_1[1], _e176.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sweep_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
