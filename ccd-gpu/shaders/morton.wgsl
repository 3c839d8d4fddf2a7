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

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_16 {
    member: array<type_14>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: u32,
}

struct type_20 {
    member: type_7,
    member_1: type_8,
    member_2: type_19,
}

struct type_21 {
    member: type_20,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(3) 
var<storage, read_write> keys: type_11;
@group(0) @binding(4) 
var<storage, read_write> order: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_16;
@group(0) @binding(2) 
var<storage> words: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_18;
    var local_2: type_18;
    var local_3: type_22;
    var local_4: type_18;
    var phi_138_: u32;
    var phi_141_: type_9;
    var phi_251_: type_9;
    var phi_254_: f32;
    var phi_255_: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_317_: f32;
    var phi_367_: type_9;
    var phi_455_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e58 = ((((_e44.y * _e45.x) + _e44.x) * 256u) + _e46);
    let _e62 = params.member.member.member_2[3u];
    if (_e58 < _e62) {
        let _e67 = params.member.member.member_2[2u];
        if (_e58 >= _e67) {
            phi_138_ = 2u;
        } else {
            let _e70 = params.member.member.member_2[1u];
            phi_138_ = select(0u, 1u, (_e58 >= _e70));
        }
        let _e74 = phi_138_;
        local_2 = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_141_ = type_9(0u, 3u);
        loop {
            let _e76 = phi_141_;
            let _e79 = (_e76.member < _e76.member_1);
            let _e90 = select(type_9().member_1, _e76.member, _e79);
            let _e92 = (bitcast<i32>(select(0u, 1u, _e79)) != 0i);
            if _e92 {
                let _e94 = words.member[_e90];
                let _e95 = ~(_e94);
                local_2.member[_e90] = bitcast<f32>(select(~(_e95), (_e95 & 2147483647u), ((_e95 >> bitcast<u32>(31i)) == 1u)));
                let _e107 = words.member[(3u + _e90)];
                local_2.member_1[_e90] = bitcast<f32>(select(~(_e107), (_e107 & 2147483647u), ((_e107 >> bitcast<u32>(31i)) == 1u)));
            }
            continue;
            continuing {
                phi_141_ = type_9(select(_e76.member, (_e76.member + 1u), _e79), select(_e76.member_1, _e76.member_1, _e79));
                break if !(_e92);
            }
        }
        let _e118 = local_2;
        local_4 = _e118;
        phi_251_ = type_9(0u, 3u);
        phi_254_ = 0f;
        loop {
            let _e120 = phi_251_;
            let _e122 = phi_254_;
            local_5 = _e122;
            local_6 = _e122;
            let _e125 = (_e120.member < _e120.member_1);
            let _e136 = select(type_9().member_1, _e120.member, _e125);
            let _e138 = (bitcast<i32>(select(0u, 1u, _e125)) != 0i);
            if _e138 {
                let _e141 = local_4.member_1[_e136];
                let _e145 = local_4.member[_e136];
                let _e147 = ((_e141 * 0.5f) - (_e145 * 0.5f));
                phi_255_ = select(_e122, _e147, (_e147 > _e122));
            } else {
                phi_255_ = f32();
            }
            let _e151 = phi_255_;
            continue;
            continuing {
                phi_251_ = type_9(select(_e120.member, (_e120.member + 1u), _e125), select(_e120.member_1, _e120.member_1, _e125));
                phi_254_ = _e151;
                break if !(_e138);
            }
        }
        let _e154 = local_5;
        if (_e154 > 0.000000000000000000000000000001f) {
            let _e158 = local_6;
            phi_317_ = ((0.5f * 1024f) / _e158);
        } else {
            phi_317_ = 0f;
        }
        let _e161 = phi_317_;
        let _e163 = local_4.member;
        local_3 = type_22(_e163, _e161, (1024f - 1f));
        let _e169 = boxes.member[_e58];
        local_1 = type_18(array<f32, 3>(_e169.member.x, _e169.member.y, _e169.member_1.x), array<f32, 3>(_e169.member_1.y, _e169.member_2.x, _e169.member_2.y));
        local = array<u32, 3>(0u, 0u, 0u);
        phi_367_ = type_9(0u, 3u);
        loop {
            let _e186 = phi_367_;
            let _e189 = (_e186.member < _e186.member_1);
            let _e200 = select(type_9().member_1, _e186.member, _e189);
            let _e202 = (bitcast<i32>(select(0u, 1u, _e189)) != 0i);
            if _e202 {
                let _e205 = local_1.member[_e200];
                let _e209 = local_1.member_1[_e200];
                let _e214 = local_3.member[_e200];
                let _e217 = local_3.member_1;
                let _e218 = ((((_e205 * 0.5f) + (_e209 * 0.5f)) - _e214) * _e217);
                let _e220 = local_3.member_2;
                if (_e218 >= _e220) {
                    let _e230 = local_3.member_2;
                    phi_455_ = select(select(u32(_e230), 0u, (_e230 < 0f)), 4294967295u, (_e230 > 4294967000f));
                } else {
                    phi_455_ = select(0u, select(select(u32(_e218), 0u, (_e218 < 0f)), 4294967295u, (_e218 > 4294967000f)), (_e218 > 0f));
                }
                let _e237 = phi_455_;
                local[_e200] = _e237;
            }
            continue;
            continuing {
                phi_367_ = type_9(select(_e186.member, (_e186.member + 1u), _e189), select(_e186.member_1, _e186.member_1, _e189));
                break if !(_e202);
            }
        }
        let _e240 = local;
        let _e244 = (_e240[0] & 1023u);
        let _e248 = ((_e244 | (_e244 << bitcast<u32>(16i))) & 50331903u);
        let _e252 = ((_e248 | (_e248 << bitcast<u32>(8i))) & 50393103u);
        let _e256 = ((_e252 | (_e252 << bitcast<u32>(4i))) & 51130563u);
        let _e263 = (_e240[1] & 1023u);
        let _e267 = ((_e263 | (_e263 << bitcast<u32>(16i))) & 50331903u);
        let _e271 = ((_e267 | (_e267 << bitcast<u32>(8i))) & 50393103u);
        let _e275 = ((_e271 | (_e271 << bitcast<u32>(4i))) & 51130563u);
        let _e283 = (_e240[2] & 1023u);
        let _e287 = ((_e283 | (_e283 << bitcast<u32>(16i))) & 50331903u);
        let _e291 = ((_e287 | (_e287 << bitcast<u32>(8i))) & 50393103u);
        let _e295 = ((_e291 | (_e291 << bitcast<u32>(4i))) & 51130563u);
        keys.member[_e58] = ((_e74 << bitcast<u32>(30i)) | (((((_e256 | (_e256 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e275 | (_e275 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e295 | (_e295 << bitcast<u32>(2i))) & 153391689u)));
        order.member[_e58] = _e58;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn morton(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
