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

struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
    member_18: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
}

@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> control: type_11;
@group(0) @binding(2) 
var<storage, read_write> nodes: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_235_: type_9;
    var phi_281_: type_9;
    var phi_284_: u32;
    var phi_285_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_487_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e19 = id_2;
    let _e20 = n_2;
    let _e21 = lane_2;
    let _e32 = params.member.member_2.member_3;
    let _e35 = params.member.member_2.member_7;
    let _e38 = params.member.member_1.member_1;
    let _e40 = control.member[_e38];
    let _e42 = select(_e40, _e32, (_e32 < _e40));
    let _e59 = control.member[((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u)))))];
    let _e75 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (1u << bitcast<u32>((_e35 & 31u))))];
    let _e76 = (_e75 - _e59);
    let _e84 = (((_e76 + (1u << bitcast<u32>((_e35 & 31u)))) - 1u) >> bitcast<u32>((_e35 & 31u)));
    let _e85 = (((_e19.y * _e20.x) + _e19.x) * _e84);
    let _e87 = select(_e85, _e76, (_e76 < _e85));
    let _e88 = (_e76 - _e87);
    let _e90 = select(_e84, _e88, (_e88 < _e84));
    let _e91 = (_e90 / 128u);
    phi_235_ = type_9(0u, select(_e91, (_e91 + 1u), ((_e90 % 128u) > 0u)));
    loop {
        let _e98 = phi_235_;
        let _e101 = (_e98.member < _e98.member_1);
        let _e114 = (bitcast<i32>(select(0u, 1u, _e101)) != 0i);
        if _e114 {
            let _e116 = ((select(type_9().member_1, _e98.member, _e101) * 128u) + _e21);
            let _e118 = ((_e59 + _e87) + _e116);
            if (_e116 < _e90) {
                if (_e118 < _e32) {
                    phi_281_ = type_9(0u, _e35);
                    phi_284_ = 0u;
                    loop {
                        let _e123 = phi_281_;
                        let _e125 = phi_284_;
                        local = _e125;
                        local_1 = _e125;
                        local_2 = _e125;
                        local_3 = _e125;
                        local_4 = _e125;
                        let _e128 = (_e123.member < _e123.member_1);
                        let _e141 = (bitcast<i32>(select(0u, 1u, _e128)) != 0i);
                        if _e141 {
                            let _e147 = (_e125 + (1u << bitcast<u32>((((_e35 - 1u) - select(type_9().member_1, _e123.member, _e128)) & 31u))));
                            let _e160 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + _e147)];
                            phi_285_ = select(_e125, _e147, (_e160 <= _e118));
                        } else {
                            phi_285_ = u32();
                        }
                        let _e164 = phi_285_;
                        continue;
                        continuing {
                            phi_281_ = type_9(select(_e123.member, (_e123.member + 1u), _e128), select(_e123.member_1, _e123.member_1, _e128));
                            phi_284_ = _e164;
                            break if !(_e141);
                        }
                    }
                    let _e177 = local;
                    let _e180 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + _e177)];
                    let _e181 = (_e118 - _e180);
                    let _e188 = local_1;
                    let _e192 = control.member[((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * _e188))];
                    if (_e181 < _e192) {
                        let _e251 = local_4;
                        let _e255 = ((((((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (1u << bitcast<u32>((_e35 & 31u)))) + 1u) + (_e251 * 2048u)) + (2u * _e181));
                        let _e257 = control.member[_e255];
                        let _e260 = control.member[(_e255 + 1u)];
                        phi_487_ = type_9(_e257, _e260);
                    } else {
                        let _e200 = local_2;
                        let _e205 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * _e200)) + 1u)];
                        let _e213 = (((_e42 + (1u << bitcast<u32>((_e35 & 31u)))) - 1u) >> bitcast<u32>((_e35 & 31u)));
                        let _e215 = local_3;
                        let _e216 = (_e215 * _e213);
                        let _e218 = select(_e216, _e42, (_e42 < _e216));
                        let _e219 = (_e42 - _e218);
                        let _e227 = (2u * (((((((_e38 % 2u) * _e32) + _e218) + select(_e213, _e219, (_e219 < _e213))) - _e205) + _e181) - _e192));
                        let _e230 = nodes.member[(4u + _e227)];
                        let _e233 = nodes.member[(_e227 + 5u)];
                        phi_487_ = type_9(_e230, _e233);
                    }
                    let _e263 = phi_487_;
                    let _e264 = (((1u - (_e38 % 2u)) * _e32) + _e118);
                    if (_e264 < 4294967295u) {
                        let _e268 = (2u * _e264);
                        nodes.member[(4u + _e268)] = _e263.member;
                        nodes.member[(_e268 + 5u)] = _e263.member_1;
                    }
                }
            }
        }
        continue;
        continuing {
            phi_235_ = type_9(select(_e98.member, (_e98.member + 1u), _e101), select(_e98.member_1, _e98.member_1, _e101));
            break if !(_e114);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn balance_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
