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
    var phi_152_: u32;
    var phi_210_: u32;
    var phi_216_: u32;
    var phi_232_: u32;
    var phi_235_: type_9;
    var phi_236_: type_9;
    var phi_259_: type_9;
    var phi_281_: type_9;
    var phi_284_: u32;
    var phi_282_: type_9;
    var phi_307_: type_9;
    var phi_343_: u32;
    var phi_285_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_451_: u32;
    var phi_457_: u32;
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
    if (_e32 < _e40) {
        phi_152_ = _e32;
    } else {
        phi_152_ = _e40;
    }
    let _e43 = phi_152_;
    let _e60 = control.member[((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u)))))];
    let _e76 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (1u << bitcast<u32>((_e35 & 31u))))];
    let _e77 = (_e76 - _e60);
    let _e85 = (((_e77 + (1u << bitcast<u32>((_e35 & 31u)))) - 1u) >> bitcast<u32>((_e35 & 31u)));
    let _e86 = (((_e19.y * _e20.x) + _e19.x) * _e85);
    if (_e77 < _e86) {
        phi_210_ = _e77;
    } else {
        phi_210_ = _e86;
    }
    let _e89 = phi_210_;
    let _e90 = (_e77 - _e89);
    if (_e90 < _e85) {
        phi_216_ = _e90;
    } else {
        phi_216_ = _e85;
    }
    let _e93 = phi_216_;
    let _e94 = (_e93 / 128u);
    if ((_e93 % 128u) > 0u) {
        phi_232_ = (_e94 + 1u);
    } else {
        phi_232_ = _e94;
    }
    let _e99 = phi_232_;
    phi_235_ = type_9(0u, _e99);
    loop {
        let _e102 = phi_235_;
        if (_e102.member < _e102.member_1) {
            phi_236_ = type_9((_e102.member + 1u), _e102.member_1);
            phi_259_ = type_9(1u, _e102.member);
        } else {
            phi_236_ = _e102;
            phi_259_ = type_9(0u, type_9().member_1);
        }
        let _e114 = phi_236_;
        let _e116 = phi_259_;
        let _e120 = (bitcast<i32>(_e116.member) != 0i);
        if _e120 {
            let _e122 = ((_e116.member_1 * 128u) + _e21);
            let _e124 = ((_e60 + _e89) + _e122);
            if (_e122 < _e93) {
                if (_e124 < _e32) {
                    phi_281_ = type_9(0u, _e35);
                    phi_284_ = 0u;
                    loop {
                        let _e129 = phi_281_;
                        let _e131 = phi_284_;
                        local = _e131;
                        local_1 = _e131;
                        local_2 = _e131;
                        local_3 = _e131;
                        local_4 = _e131;
                        if (_e129.member < _e129.member_1) {
                            phi_282_ = type_9((_e129.member + 1u), _e129.member_1);
                            phi_307_ = type_9(1u, _e129.member);
                        } else {
                            phi_282_ = _e129;
                            phi_307_ = type_9(0u, type_9().member_1);
                        }
                        let _e143 = phi_282_;
                        let _e145 = phi_307_;
                        let _e149 = (bitcast<i32>(_e145.member) != 0i);
                        if _e149 {
                            let _e155 = (_e131 + (1u << bitcast<u32>((((_e35 - 1u) - _e145.member_1) & 31u))));
                            let _e168 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + _e155)];
                            if (_e168 <= _e124) {
                                phi_343_ = _e155;
                            } else {
                                phi_343_ = _e131;
                            }
                            let _e171 = phi_343_;
                            phi_285_ = _e171;
                        } else {
                            phi_285_ = u32();
                        }
                        let _e173 = phi_285_;
                        continue;
                        continuing {
                            phi_281_ = _e143;
                            phi_284_ = _e173;
                            break if !(_e149);
                        }
                    }
                    let _e186 = local;
                    let _e189 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + _e186)];
                    let _e190 = (_e124 - _e189);
                    let _e197 = local_1;
                    let _e201 = control.member[((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * _e197))];
                    if (_e190 < _e201) {
                        let _e262 = local_4;
                        let _e266 = ((((((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (1u << bitcast<u32>((_e35 & 31u)))) + 1u) + (_e262 * 2048u)) + (2u * _e190));
                        let _e268 = control.member[_e266];
                        let _e271 = control.member[(_e266 + 1u)];
                        phi_487_ = type_9(_e268, _e271);
                    } else {
                        let _e209 = local_2;
                        let _e214 = control.member[(((1540u + (2u * (1u << bitcast<u32>((_e35 & 31u))))) + (2u * _e209)) + 1u)];
                        let _e222 = (((_e43 + (1u << bitcast<u32>((_e35 & 31u)))) - 1u) >> bitcast<u32>((_e35 & 31u)));
                        let _e224 = local_3;
                        let _e225 = (_e224 * _e222);
                        if (_e43 < _e225) {
                            phi_451_ = _e43;
                        } else {
                            phi_451_ = _e225;
                        }
                        let _e228 = phi_451_;
                        let _e229 = (_e43 - _e228);
                        if (_e229 < _e222) {
                            phi_457_ = _e229;
                        } else {
                            phi_457_ = _e222;
                        }
                        let _e232 = phi_457_;
                        let _e238 = (2u * (((((((_e38 % 2u) * _e32) + _e228) + _e232) - _e214) + _e190) - _e201));
                        let _e241 = nodes.member[(4u + _e238)];
                        let _e244 = nodes.member[(_e238 + 5u)];
                        phi_487_ = type_9(_e241, _e244);
                    }
                    let _e274 = phi_487_;
                    let _e275 = (((1u - (_e38 % 2u)) * _e32) + _e124);
                    if (_e275 < 4294967295u) {
                        let _e279 = (2u * _e275);
                        nodes.member[(4u + _e279)] = _e274.member;
                        nodes.member[(_e279 + 5u)] = _e274.member_1;
                    }
                }
            }
        }
        continue;
        continuing {
            phi_235_ = _e114;
            break if !(_e120);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn balance_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
