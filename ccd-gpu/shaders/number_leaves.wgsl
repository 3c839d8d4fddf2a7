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

struct type_16 {
    member: array<vec4<u32>>,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> joins: type_11;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_11;
@group(0) @binding(4) 
var<storage, read_write> branches: type_16;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_100_: type_9;
    var phi_103_: u32;
    var phi_105_: u32;
    var phi_163_: u32;
    var phi_164_: bool;
    var phi_104_: u32;
    var phi_106_: u32;
    var phi_165_: bool;
    var phi_185_: u32;
    var local: u32;
    var phi_192_: type_9;
    var phi_195_: u32;
    var phi_252_: bool;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_196_: u32;
    var phi_339_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e19 = id_2;
    let _e20 = n_2;
    let _e21 = lane_2;
    let _e33 = ((((_e19.y * _e20.x) + _e19.x) * 256u) + _e21);
    let _e36 = params.member.member_2.member;
    let _e40 = params.member.member.member_2[_e36];
    let _e44 = params.member.member.member[_e36];
    if (_e33 < _e44) {
        let _e46 = (_e44 - 1u);
        phi_100_ = type_9(0u, _e46);
        phi_103_ = (_e46 + _e33);
        phi_105_ = 0u;
        loop {
            let _e50 = phi_100_;
            let _e52 = phi_103_;
            let _e54 = phi_105_;
            local = _e54;
            local_1 = _e54;
            local_2 = _e54;
            local_3 = _e54;
            local_4 = _e54;
            local_5 = _e54;
            local_6 = _e54;
            local_7 = _e54;
            let _e57 = (_e50.member < _e50.member_1);
            if (bitcast<i32>(select(0u, 1u, _e57)) != 0i) {
                let _e71 = joins.member[(_e52 * 4u)];
                if (_e71 == 4294967295u) {
                    phi_163_ = u32();
                    phi_164_ = false;
                } else {
                    let _e76 = joins.member[((_e52 * 4u) + 1u)];
                    phi_163_ = (_e54 + _e76);
                    phi_164_ = true;
                }
                let _e79 = phi_163_;
                let _e81 = phi_164_;
                phi_104_ = _e71;
                phi_106_ = _e79;
                phi_165_ = _e81;
            } else {
                phi_104_ = u32();
                phi_106_ = u32();
                phi_165_ = false;
            }
            let _e83 = phi_104_;
            let _e85 = phi_106_;
            let _e87 = phi_165_;
            continue;
            continuing {
                phi_100_ = type_9(select(_e50.member, (_e50.member + 1u), _e57), select(_e50.member_1, _e50.member_1, _e57));
                phi_103_ = _e83;
                phi_105_ = _e85;
                break if !(_e87);
            }
        }
        let _e92 = params.member.member_2.member_3;
        if (_e92 == 0u) {
            phi_185_ = (_e40 + _e33);
        } else {
            let _e96 = order.member[(_e40 + _e33)];
            phi_185_ = _e96;
        }
        let _e98 = phi_185_;
        let _e100 = local;
        ordered.member[(_e40 + _e100)] = _e98;
        phi_192_ = type_9(0u, _e46);
        phi_195_ = (_e46 + _e33);
        loop {
            let _e106 = phi_192_;
            let _e108 = phi_195_;
            let _e111 = (_e106.member < _e106.member_1);
            if (bitcast<i32>(select(0u, 1u, _e111)) != 0i) {
                let _e123 = (_e108 * 4u);
                let _e125 = joins.member[_e123];
                if (_e125 != 4294967295u) {
                    let _e129 = joins.member[(_e123 + 1u)];
                    phi_252_ = (_e129 == 0u);
                } else {
                    phi_252_ = false;
                }
                let _e132 = phi_252_;
                let _e133 = select(_e108, _e125, _e132);
                let _e134 = (_e133 * 4u);
                let _e136 = joins.member[_e134];
                let _e140 = joins.member[(_e134 + 1u)];
                let _e144 = joins.member[(_e134 + 2u)];
                let _e147 = joins.member[(_e134 + 3u)];
                let _e149 = local_1;
                let _e153 = local_2;
                let _e158 = local_3;
                let _e159 = (_e158 + _e144);
                let _e161 = local_4;
                let _e163 = (_e159 - 1u);
                let _e164 = ((_e161 + _e147) - 1u);
                let _e166 = local_5;
                let _e169 = local_6;
                if _e132 {
                    let _e176 = local_7;
                    branches.member[select(0u, select(select(_e153, ((_e149 + _e147) - 1u), (_e140 == 0u)), 0u, (_e136 == 4294967295u)), _e132)] = vec4<u32>(select(_e163, (_e46 + _e169), (_e166 == _e163)), select(_e159, (_e46 + _e159), (_e159 == _e164)), _e176, _e164);
                }
                phi_196_ = _e133;
                phi_339_ = _e132;
            } else {
                phi_196_ = u32();
                phi_339_ = false;
            }
            let _e180 = phi_196_;
            let _e182 = phi_339_;
            continue;
            continuing {
                phi_192_ = type_9(select(_e106.member, (_e106.member + 1u), _e111), select(_e106.member_1, _e106.member_1, _e111));
                phi_195_ = _e180;
                break if !(_e182);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn number_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
