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
    var phi_329_: type_9;
    var phi_397_: f32;
    var phi_424_: type_18;
    var phi_106_: type_18;
    var local_3: type_18;
    var local_4: type_18;
    var local_5: type_18;
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
        let _e45 = (_e40.member < _e40.member_1);
        let _e58 = (bitcast<i32>(select(0u, 1u, _e45)) != 0i);
        if _e58 {
            let _e62 = ((((((_e26.y * _e27.x) + _e26.x) * 32u) + select(type_9().member_1, _e40.member, _e45)) * 256u) + _e28);
            let _e65 = params.member.member_1.member;
            if (_e62 < _e65) {
                let _e68 = boxes.member[_e62];
                local_2 = type_12(array<f32, 3>(_e68.member[0], _e68.member[1], _e68.member[2]), array<f32, 3>(_e68.member_1[0], _e68.member_1[1], _e68.member_1[2]));
                let _e82 = local_2.member_1[0u];
                let _e86 = local_2.member[0u];
                let _e91 = local_2.member_1[1u];
                let _e95 = local_2.member[1u];
                let _e100 = local_2.member_1[2u];
                let _e104 = local_2.member[2u];
                local_1 = type_18(type_12(array<f32, 3>(_e68.member[0], _e68.member[1], _e68.member[2]), array<f32, 3>(_e68.member_1[0], _e68.member_1[1], _e68.member_1[2])), array<f32, 3>(((_e82 * 0.5f) - (_e86 * 0.5f)), ((_e91 * 0.5f) - (_e95 * 0.5f)), ((_e100 * 0.5f) - (_e104 * 0.5f))));
                let _e126 = local_1.member.member[0u];
                let _e134 = local_1.member.member[1u];
                let _e142 = local_1.member.member[2u];
                let _e150 = local_1.member.member_1[0u];
                let _e158 = local_1.member.member_1[1u];
                let _e166 = local_1.member.member_1[2u];
                local.member = type_12(array<f32, 3>(select(_e126, _e42.member.member[0], (_e42.member.member[0] < _e126)), select(_e134, _e42.member.member[1], (_e42.member.member[1] < _e134)), select(_e142, _e42.member.member[2], (_e42.member.member[2] < _e142))), array<f32, 3>(select(_e150, _e42.member.member_1[0], (_e42.member.member_1[0] > _e150)), select(_e158, _e42.member.member_1[1], (_e42.member.member_1[1] > _e158)), select(_e166, _e42.member.member_1[2], (_e42.member.member_1[2] > _e166))));
                local.member_1 = array<f32, 3>(_e42.member_1[0], _e42.member_1[1], _e42.member_1[2]);
                phi_329_ = type_9(0u, 3u);
                loop {
                    let _e180 = phi_329_;
                    let _e183 = (_e180.member < _e180.member_1);
                    let _e194 = select(type_9().member_1, _e180.member, _e183);
                    let _e196 = (bitcast<i32>(select(0u, 1u, _e183)) != 0i);
                    if _e196 {
                        let _e199 = local_1.member_1[_e194];
                        let _e202 = local.member_1[_e194];
                        if (_e199 > _e202) {
                            let _e209 = local_1.member_1[_e194];
                            phi_397_ = _e209;
                        } else {
                            let _e206 = local.member_1[_e194];
                            phi_397_ = _e206;
                        }
                        let _e211 = phi_397_;
                        local.member_1[_e194] = _e211;
                    }
                    continue;
                    continuing {
                        phi_329_ = type_9(select(_e180.member, (_e180.member + 1u), _e183), select(_e180.member_1, _e180.member_1, _e183));
                        break if !(_e196);
                    }
                }
                let _e215 = local;
                phi_424_ = type_18(type_12(array<f32, 3>(_e215.member.member[0], _e215.member.member[1], _e215.member.member[2]), array<f32, 3>(_e215.member.member_1[0], _e215.member.member_1[1], _e215.member.member_1[2])), array<f32, 3>(_e215.member_1[0], _e215.member_1[1], _e215.member_1[2]));
            } else {
                phi_424_ = _e42;
            }
            let _e235 = phi_424_;
            phi_106_ = _e235;
        } else {
            phi_106_ = type_18();
        }
        let _e237 = phi_106_;
        continue;
        continuing {
            phi_102_ = type_9(select(_e40.member, (_e40.member + 1u), _e45), select(_e40.member_1, _e40.member_1, _e45));
            phi_105_ = _e237;
            break if !(_e58);
        }
    }
    let _e240 = local_3;
    let _e243 = bitcast<u32>(_e240.member_1[0]);
    let _e251 = atomicMax((&sides[0u]), select((_e243 | 2147483648u), ~(_e243), ((_e243 >> bitcast<u32>(31i)) == 1u)));
    let _e253 = local_4;
    let _e256 = bitcast<u32>(_e253.member_1[1]);
    let _e264 = atomicMax((&sides[1u]), select((_e256 | 2147483648u), ~(_e256), ((_e256 >> bitcast<u32>(31i)) == 1u)));
    let _e266 = local_5;
    let _e269 = bitcast<u32>(_e266.member_1[2]);
    let _e277 = atomicMax((&sides[2u]), select((_e269 | 2147483648u), ~(_e269), ((_e269 >> bitcast<u32>(31i)) == 1u)));
    workgroupBarrier();
    if (_e28 < 3u) {
        let _e281 = atomicLoad((&sides[_e28]));
        let _e283 = atomicMax((&survey.member[(6u + _e28)]), _e281);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_sides(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
