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
    member: i32,
    member_1: i32,
}

struct type_13 {
    member: u32,
    member_1: i32,
}

struct type_15 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_26 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(2) 
var<storage, read_write> words: type_26;
var<workgroup> shared_: array<type_19, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var phi_103_: type_9;
    var phi_106_: type_19;
    var phi_198_: type_19;
    var phi_107_: type_19;
    var local_1: type_19;
    var local_2: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var phi_236_: type_12;
    var phi_239_: u32;
    var phi_237_: type_12;
    var phi_280_: type_13;
    var phi_240_: u32;
    var phi_401_: type_9;
    var phi_472_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e44 = params.member.member_1.member;
    phi_103_ = type_9(0u, 8u);
    phi_106_ = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    loop {
        let _e46 = phi_103_;
        let _e48 = phi_106_;
        local_1 = _e48;
        local_2 = _e48;
        local_3 = _e48;
        local_4 = _e48;
        let _e51 = (_e46.member < _e46.member_1);
        let _e64 = (bitcast<i32>(select(0u, 1u, _e51)) != 0i);
        if _e64 {
            let _e66 = (((((_e29.y * _e30.x) + _e29.x) * 2048u) + _e31) + (select(type_9().member_1, _e46.member, _e51) * 256u));
            if (_e66 < _e44) {
                let _e69 = boxes.member[_e66];
                phi_198_ = type_19(array<f32, 3>(select(_e69.member.x, _e48.member[0], (_e48.member[0] < _e69.member.x)), select(_e69.member.y, _e48.member[1], (_e48.member[1] < _e69.member.y)), select(_e69.member_1.x, _e48.member[2], (_e48.member[2] < _e69.member_1.x))), array<f32, 3>(select(_e69.member_1.y, _e48.member_1[0], (_e48.member_1[0] > _e69.member_1.y)), select(_e69.member_2.x, _e48.member_1[1], (_e48.member_1[1] > _e69.member_2.x)), select(_e69.member_2.y, _e48.member_1[2], (_e48.member_1[2] > _e69.member_2.y))));
            } else {
                phi_198_ = _e48;
            }
            let _e110 = phi_198_;
            phi_107_ = _e110;
        } else {
            phi_107_ = type_19();
        }
        let _e112 = phi_107_;
        continue;
        continuing {
            phi_103_ = type_9(select(_e46.member, (_e46.member + 1u), _e51), select(_e46.member_1, _e46.member_1, _e51));
            phi_106_ = _e112;
            break if !(_e64);
        }
    }
    let _e115 = local_1;
    let _e122 = local_2;
    local = type_19(array<f32, 3>(_e115.member[0], _e115.member[1], _e115.member[2]), array<f32, 3>(_e122.member_1[0], _e122.member_1[1], _e122.member_1[2]));
    let _e131 = local_3;
    let _e138 = local_4;
    shared_[_e31] = type_19(array<f32, 3>(_e131.member[0], _e131.member[1], _e131.member[2]), array<f32, 3>(_e138.member_1[0], _e138.member_1[1], _e138.member_1[2]));
    phi_236_ = type_12(0i, 8i);
    phi_239_ = 128u;
    loop {
        let _e146 = phi_236_;
        let _e148 = phi_239_;
        if (_e146.member < _e146.member_1) {
            let _e155 = (_e146.member + 1i);
            phi_237_ = type_12(select(_e155, type_13().member_1, select(false, true, ((false == (_e155 > _e146.member)) != false))), _e146.member_1);
            phi_280_ = type_13(1u, _e146.member);
        } else {
            phi_237_ = _e146;
            phi_280_ = type_13(0u, type_13().member_1);
        }
        let _e166 = phi_237_;
        let _e168 = phi_280_;
        let _e171 = (bitcast<i32>(_e168.member) != 0i);
        if _e171 {
            workgroupBarrier();
            if (_e31 < _e148) {
                let _e175 = shared_[(_e31 + _e148)];
                let _e186 = local.member[0u];
                let _e188 = select(_e175.member[0], _e186, (_e186 < _e175.member[0]));
                let _e191 = local.member[1u];
                let _e193 = select(_e175.member[1], _e191, (_e191 < _e175.member[1]));
                let _e196 = local.member[2u];
                let _e198 = select(_e175.member[2], _e196, (_e196 < _e175.member[2]));
                let _e201 = local.member_1[0u];
                let _e203 = select(_e175.member_1[0], _e201, (_e201 > _e175.member_1[0]));
                let _e206 = local.member_1[1u];
                let _e208 = select(_e175.member_1[1], _e206, (_e206 > _e175.member_1[1]));
                let _e211 = local.member_1[2u];
                let _e213 = select(_e175.member_1[2], _e211, (_e211 > _e175.member_1[2]));
                local = type_19(array<f32, 3>(_e188, _e193, _e198), array<f32, 3>(_e203, _e208, _e213));
                shared_[_e31] = type_19(array<f32, 3>(_e188, _e193, _e198), array<f32, 3>(_e203, _e208, _e213));
            }
            phi_240_ = (_e148 / 2u);
        } else {
            phi_240_ = u32();
        }
        let _e223 = phi_240_;
        continue;
        continuing {
            phi_236_ = _e166;
            phi_239_ = _e223;
            break if !(_e171);
        }
    }
    if (_e31 == 0u) {
        phi_401_ = type_9(0u, 6u);
        loop {
            let _e227 = phi_401_;
            let _e230 = (_e227.member < _e227.member_1);
            let _e241 = select(type_9().member_1, _e227.member, _e230);
            let _e243 = (bitcast<i32>(select(0u, 1u, _e230)) != 0i);
            if _e243 {
                if (_e241 < 3u) {
                    let _e258 = local.member[_e241];
                    let _e259 = bitcast<u32>(_e258);
                    phi_472_ = ~(select((_e259 | 2147483648u), ~(_e259), ((_e259 >> bitcast<u32>(31i)) == 1u)));
                } else {
                    let _e248 = local.member_1[(_e241 - 3u)];
                    let _e249 = bitcast<u32>(_e248);
                    phi_472_ = select((_e249 | 2147483648u), ~(_e249), ((_e249 >> bitcast<u32>(31i)) == 1u));
                }
                let _e268 = phi_472_;
                let _e270 = atomicMax((&words.member[_e241]), _e268);
            }
            continue;
            continuing {
                phi_401_ = type_9(select(_e227.member, (_e227.member + 1u), _e230), select(_e227.member_1, _e227.member_1, _e230));
                break if !(_e243);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn scene_bounds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
