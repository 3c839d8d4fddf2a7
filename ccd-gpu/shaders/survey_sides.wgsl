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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_14 {
    member: array<type_12>,
}

struct type_15 {
    member: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

struct type_18 {
    member: type_12,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> boxes: type_14;
@group(0) @binding(2) 
var<storage, read_write> survey: type_21;
var<workgroup> sides: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_18;
    var local_1: type_18;
    var local_2: type_12;
    var phi_102_: type_9;
    var phi_105_: type_18;
    var phi_103_: type_9;
    var phi_128_: type_9;
    var phi_262_: f32;
    var phi_270_: f32;
    var phi_278_: f32;
    var phi_288_: f32;
    var phi_297_: f32;
    var phi_306_: f32;
    var phi_329_: type_9;
    var phi_330_: type_9;
    var phi_353_: type_9;
    var phi_397_: f32;
    var phi_424_: type_18;
    var phi_106_: type_18;
    var local_3: type_18;
    var phi_434_: u32;
    var local_4: type_18;
    var phi_446_: u32;
    var local_5: type_18;
    var phi_458_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e26 = id_2;
    let _e27 = n_2;
    let _e28 = lane_2;
    if (_e28 < 3u) {
        atomicStore((&sides[_e28]), 0u);
    }
    workgroupBarrier();
    phi_102_ = type_9(0u, 32u);
    phi_105_ = type_18(type_12(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f)), array<f32, 3>(0f, 0f, 0f));
    loop {
        let _e40 = phi_102_;
        let _e42 = phi_105_;
        local_3 = _e42;
        local_4 = _e42;
        local_5 = _e42;
        if (_e40.member < _e40.member_1) {
            phi_103_ = type_9((_e40.member + 1u), _e40.member_1);
            phi_128_ = type_9(1u, _e40.member);
        } else {
            phi_103_ = _e40;
            phi_128_ = type_9(0u, type_9().member_1);
        }
        let _e54 = phi_103_;
        let _e56 = phi_128_;
        let _e60 = (bitcast<i32>(_e56.member) != 0i);
        if _e60 {
            let _e64 = ((((((_e26.y * _e27.x) + _e26.x) * 32u) + _e56.member_1) * 256u) + _e28);
            let _e67 = params.member.member_1.member;
            if (_e64 < _e67) {
                let _e70 = boxes.member[_e64];
                local_2 = type_12(array<f32, 3>(_e70.member[0], _e70.member[1], _e70.member[2]), array<f32, 3>(_e70.member_1[0], _e70.member_1[1], _e70.member_1[2]));
                let _e84 = local_2.member_1[0u];
                let _e88 = local_2.member[0u];
                let _e93 = local_2.member_1[1u];
                let _e97 = local_2.member[1u];
                let _e102 = local_2.member_1[2u];
                let _e106 = local_2.member[2u];
                local_1 = type_18(type_12(array<f32, 3>(_e70.member[0], _e70.member[1], _e70.member[2]), array<f32, 3>(_e70.member_1[0], _e70.member_1[1], _e70.member_1[2])), array<f32, 3>(((_e84 * 0.5f) - (_e88 * 0.5f)), ((_e93 * 0.5f) - (_e97 * 0.5f)), ((_e102 * 0.5f) - (_e106 * 0.5f))));
                let _e128 = local_1.member.member[0u];
                if (_e42.member.member[0] < _e128) {
                    phi_262_ = _e42.member.member[0];
                } else {
                    phi_262_ = _e128;
                }
                let _e131 = phi_262_;
                let _e137 = local_1.member.member[1u];
                if (_e42.member.member[1] < _e137) {
                    phi_270_ = _e42.member.member[1];
                } else {
                    phi_270_ = _e137;
                }
                let _e140 = phi_270_;
                let _e146 = local_1.member.member[2u];
                if (_e42.member.member[2] < _e146) {
                    phi_278_ = _e42.member.member[2];
                } else {
                    phi_278_ = _e146;
                }
                let _e149 = phi_278_;
                let _e155 = local_1.member.member_1[0u];
                if (_e42.member.member_1[0] > _e155) {
                    phi_288_ = _e42.member.member_1[0];
                } else {
                    phi_288_ = _e155;
                }
                let _e158 = phi_288_;
                let _e164 = local_1.member.member_1[1u];
                if (_e42.member.member_1[1] > _e164) {
                    phi_297_ = _e42.member.member_1[1];
                } else {
                    phi_297_ = _e164;
                }
                let _e167 = phi_297_;
                let _e173 = local_1.member.member_1[2u];
                if (_e42.member.member_1[2] > _e173) {
                    phi_306_ = _e42.member.member_1[2];
                } else {
                    phi_306_ = _e173;
                }
                let _e176 = phi_306_;
                local.member = type_12(array<f32, 3>(_e131, _e140, _e149), array<f32, 3>(_e158, _e167, _e176));
                local.member_1 = array<f32, 3>(_e42.member_1[0], _e42.member_1[1], _e42.member_1[2]);
                phi_329_ = type_9(0u, 3u);
                loop {
                    let _e188 = phi_329_;
                    if (_e188.member < _e188.member_1) {
                        phi_330_ = type_9((_e188.member + 1u), _e188.member_1);
                        phi_353_ = type_9(1u, _e188.member);
                    } else {
                        phi_330_ = _e188;
                        phi_353_ = type_9(0u, type_9().member_1);
                    }
                    let _e200 = phi_330_;
                    let _e202 = phi_353_;
                    let _e206 = (bitcast<i32>(_e202.member) != 0i);
                    if _e206 {
                        let _e209 = local_1.member_1[_e202.member_1];
                        let _e212 = local.member_1[_e202.member_1];
                        if (_e209 > _e212) {
                            let _e219 = local_1.member_1[_e202.member_1];
                            phi_397_ = _e219;
                        } else {
                            let _e216 = local.member_1[_e202.member_1];
                            phi_397_ = _e216;
                        }
                        let _e221 = phi_397_;
                        local.member_1[_e202.member_1] = _e221;
                    }
                    continue;
                    continuing {
                        phi_329_ = _e200;
                        break if !(_e206);
                    }
                }
                let _e225 = local;
                phi_424_ = type_18(type_12(array<f32, 3>(_e225.member.member[0], _e225.member.member[1], _e225.member.member[2]), array<f32, 3>(_e225.member.member_1[0], _e225.member.member_1[1], _e225.member.member_1[2])), array<f32, 3>(_e225.member_1[0], _e225.member_1[1], _e225.member_1[2]));
            } else {
                phi_424_ = _e42;
            }
            let _e245 = phi_424_;
            phi_106_ = _e245;
        } else {
            phi_106_ = type_18();
        }
        let _e247 = phi_106_;
        continue;
        continuing {
            phi_102_ = _e54;
            phi_105_ = _e247;
            break if !(_e60);
        }
    }
    let _e250 = local_3;
    let _e253 = bitcast<u32>(_e250.member_1[0]);
    if ((_e253 >> bitcast<u32>(31i)) == 1u) {
        phi_434_ = ~(_e253);
    } else {
        phi_434_ = (_e253 | 2147483648u);
    }
    let _e260 = phi_434_;
    let _e262 = atomicMax((&sides[0u]), _e260);
    let _e264 = local_4;
    let _e267 = bitcast<u32>(_e264.member_1[1]);
    if ((_e267 >> bitcast<u32>(31i)) == 1u) {
        phi_446_ = ~(_e267);
    } else {
        phi_446_ = (_e267 | 2147483648u);
    }
    let _e274 = phi_446_;
    let _e276 = atomicMax((&sides[1u]), _e274);
    let _e278 = local_5;
    let _e281 = bitcast<u32>(_e278.member_1[2]);
    if ((_e281 >> bitcast<u32>(31i)) == 1u) {
        phi_458_ = ~(_e281);
    } else {
        phi_458_ = (_e281 | 2147483648u);
    }
    let _e288 = phi_458_;
    let _e290 = atomicMax((&sides[2u]), _e288);
    workgroupBarrier();
    if (_e28 < 3u) {
        let _e294 = atomicLoad((&sides[_e28]));
        let _e296 = atomicMax((&survey.member[(6u + _e28)]), _e294);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_sides(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
