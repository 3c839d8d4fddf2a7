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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: u32,
    member_1: f32,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
    member: vec4<u32>,
    member_1: vec4<u32>,
}

struct type_24 {
    member: array<type_22>,
}

@group(0) @binding(0) 
var<storage> params: type_21;
@group(0) @binding(1) 
var<storage> clusters: type_24;
@group(0) @binding(2) 
var<storage, read_write> neighbours: type_11;
@group(0) @binding(3) 
var<storage, read_write> counts: type_11;
var<workgroup> near: array<type_16, 512>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_108_: u32;
    var phi_116_: type_9;
    var phi_117_: type_9;
    var phi_140_: type_9;
    var phi_195_: type_16;
    var phi_196_: type_16;
    var phi_197_: type_16;
    var phi_230_: u32;
    var phi_244_: u32;
    var phi_255_: u32;
    var phi_281_: u32;
    var phi_289_: u32;
    var phi_293_: type_9;
    var phi_296_: type_18;
    var phi_294_: type_9;
    var phi_319_: type_9;
    var phi_349_: f32;
    var phi_356_: f32;
    var phi_364_: f32;
    var phi_371_: f32;
    var phi_379_: f32;
    var phi_386_: f32;
    var phi_415_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_425_: type_18;
    var phi_426_: type_18;
    var phi_297_: type_18;
    var local: type_18;
    var phi_428_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e24 = id_2;
    let _e25 = n_2;
    let _e26 = lane_2;
    let _e35 = ((_e24.y * _e25.x) + _e24.x);
    let _e38 = params.member.member_1.member_1;
    let _e40 = counts.member[_e38];
    if (_e40 > 256u) {
        phi_108_ = _e40;
    } else {
        phi_108_ = 0u;
    }
    let _e43 = phi_108_;
    let _e46 = params.member.member_2.member_1;
    let _e48 = ((_e35 * 256u) + _e26);
    phi_116_ = type_9(0u, 2u);
    loop {
        let _e50 = phi_116_;
        if (_e50.member < _e50.member_1) {
            phi_117_ = type_9((_e50.member + 1u), _e50.member_1);
            phi_140_ = type_9(1u, _e50.member);
        } else {
            phi_117_ = _e50;
            phi_140_ = type_9(0u, type_9().member_1);
        }
        let _e62 = phi_117_;
        let _e64 = phi_140_;
        let _e68 = (bitcast<i32>(_e64.member) != 0i);
        if _e68 {
            let _e70 = ((_e64.member_1 * 256u) + _e26);
            let _e72 = ((_e35 * 256u) + _e70);
            if (_e72 >= _e46) {
                if ((_e72 - _e46) < _e43) {
                    if (_e70 < (256u + (2u * _e46))) {
                        let _e81 = clusters.member[(_e72 - _e46)];
                        phi_195_ = type_16(array<f32, 3>(bitcast<f32>(_e81.member.x), bitcast<f32>(_e81.member.y), bitcast<f32>(_e81.member.z)), array<f32, 3>(bitcast<f32>(_e81.member_1.x), bitcast<f32>(_e81.member_1.y), bitcast<f32>(_e81.member_1.z)));
                    } else {
                        phi_195_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    }
                    let _e100 = phi_195_;
                    phi_196_ = _e100;
                } else {
                    phi_196_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                }
                let _e102 = phi_196_;
                phi_197_ = _e102;
            } else {
                phi_197_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e104 = phi_197_;
            near[_e70] = type_16(array<f32, 3>(_e104.member[0], _e104.member[1], _e104.member[2]), array<f32, 3>(_e104.member_1[0], _e104.member_1[1], _e104.member_1[2]));
        }
        continue;
        continuing {
            phi_116_ = _e62;
            break if !(_e68);
        }
    }
    workgroupBarrier();
    if (_e48 < _e43) {
        let _e121 = params.member.member_2.member;
        let _e125 = params.member.member.member[_e121];
        if ((_e48 ^ 1u) < _e43) {
            phi_230_ = (_e48 ^ 1u);
        } else {
            phi_230_ = _e48;
        }
        let _e130 = phi_230_;
        let _e133 = params.member.member_1.member_1;
        if (_e125 > 1u) {
            let _e135 = (_e125 - 1u);
            phi_244_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e135)), 32u, (_e135 == 0u)));
        } else {
            phi_244_ = 0u;
        }
        let _e143 = phi_244_;
        if (_e43 > 1u) {
            let _e145 = (_e43 - 1u);
            phi_255_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e145)), 32u, (_e145 == 0u)));
        } else {
            phi_255_ = 0u;
        }
        let _e153 = phi_255_;
        if (_e133 >= (6u * ((_e143 - _e153) + 1u))) {
            phi_428_ = _e130;
        } else {
            let _e160 = near[(_e46 + _e26)];
            if (_e48 < _e46) {
                phi_281_ = _e48;
            } else {
                phi_281_ = _e46;
            }
            let _e171 = phi_281_;
            let _e174 = ((_e48 + _e46) + 1u);
            if (_e43 < _e174) {
                phi_289_ = _e43;
            } else {
                phi_289_ = _e174;
            }
            let _e177 = phi_289_;
            phi_293_ = type_9((_e48 - _e171), _e177);
            phi_296_ = type_18(_e48, 300000000000000000000000000000000000000f);
            loop {
                let _e181 = phi_293_;
                let _e183 = phi_296_;
                local = _e183;
                if (_e181.member < _e181.member_1) {
                    phi_294_ = type_9((_e181.member + 1u), _e181.member_1);
                    phi_319_ = type_9(1u, _e181.member);
                } else {
                    phi_294_ = _e181;
                    phi_319_ = type_9(0u, type_9().member_1);
                }
                let _e195 = phi_294_;
                let _e197 = phi_319_;
                let _e201 = (bitcast<i32>(_e197.member) != 0i);
                if _e201 {
                    let _e206 = near[((_e197.member_1 + _e46) - (_e35 * 256u))];
                    if (_e160.member_1[0] > _e206.member_1[0]) {
                        phi_349_ = _e160.member_1[0];
                    } else {
                        phi_349_ = _e206.member_1[0];
                    }
                    let _e217 = phi_349_;
                    if (_e160.member[0] < _e206.member[0]) {
                        phi_356_ = _e160.member[0];
                    } else {
                        phi_356_ = _e206.member[0];
                    }
                    let _e220 = phi_356_;
                    let _e221 = (_e217 - _e220);
                    if (_e160.member_1[1] > _e206.member_1[1]) {
                        phi_364_ = _e160.member_1[1];
                    } else {
                        phi_364_ = _e206.member_1[1];
                    }
                    let _e224 = phi_364_;
                    if (_e160.member[1] < _e206.member[1]) {
                        phi_371_ = _e160.member[1];
                    } else {
                        phi_371_ = _e206.member[1];
                    }
                    let _e227 = phi_371_;
                    let _e228 = (_e224 - _e227);
                    if (_e160.member_1[2] > _e206.member_1[2]) {
                        phi_379_ = _e160.member_1[2];
                    } else {
                        phi_379_ = _e206.member_1[2];
                    }
                    let _e231 = phi_379_;
                    if (_e160.member[2] < _e206.member[2]) {
                        phi_386_ = _e160.member[2];
                    } else {
                        phi_386_ = _e206.member[2];
                    }
                    let _e234 = phi_386_;
                    let _e235 = (_e231 - _e234);
                    let _e240 = (((_e221 * _e228) + (_e228 * _e235)) + (_e235 * _e221));
                    if (_e197.member_1 != _e48) {
                        if (_e240 < _e183.member_1) {
                            phi_420_ = true;
                        } else {
                            if (_e240 == _e183.member_1) {
                                if (_e183.member == _e48) {
                                    phi_415_ = true;
                                } else {
                                    phi_415_ = ((_e48 ^ _e197.member_1) < (_e48 ^ _e183.member));
                                }
                                let _e252 = phi_415_;
                                phi_419_ = _e252;
                            } else {
                                phi_419_ = false;
                            }
                            let _e254 = phi_419_;
                            phi_420_ = _e254;
                        }
                        let _e256 = phi_420_;
                        if _e256 {
                            phi_425_ = type_18(_e197.member_1, _e240);
                        } else {
                            phi_425_ = _e183;
                        }
                        let _e259 = phi_425_;
                        phi_426_ = _e259;
                    } else {
                        phi_426_ = _e183;
                    }
                    let _e261 = phi_426_;
                    phi_297_ = _e261;
                } else {
                    phi_297_ = type_18();
                }
                let _e263 = phi_297_;
                continue;
                continuing {
                    phi_293_ = _e195;
                    phi_296_ = _e263;
                    break if !(_e201);
                }
            }
            let _e266 = local;
            phi_428_ = _e266.member;
        }
        let _e269 = phi_428_;
        neighbours.member[_e48] = _e269;
        if (_e26 == 0u) {
            if ((_e35 % 256u) == 0u) {
                counts.member[(192u + (_e35 / 256u))] = 0u;
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_nearest(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
