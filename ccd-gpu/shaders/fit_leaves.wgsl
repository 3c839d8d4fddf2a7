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

struct type_22 {
    member: array<vec4<u32>>,
}

struct type_24 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_31 {
    member: array<vec4<f32>>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: array<type_33>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> boxes: type_26;
@group(0) @binding(2) 
var<storage> leaves: type_22;
@group(0) @binding(4) 
var<storage> bodies: type_10;
var<workgroup> shared_: array<type_28, 256>;
@group(0) @binding(3) 
var<storage> paths: type_35;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_26;
@group(0) @binding(6) 
var<storage, read_write> ends: type_31;

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: f32, param_3: f32) -> f32 {
    return select(param_2, param_3, select((param_3 <= param_2), true, (param_2 != param_2)));
}

fn function_2(param_4: array<f32, 4>, param_5: array<f32, 4>, param_6: array<f32, 4>) -> type_28 {
    let _e9 = function_1(param_4[0], param_5[0]);
    let _e10 = function_1(param_4[1], param_5[1]);
    let _e11 = function_1(param_4[2], param_5[2]);
    let _e12 = function_(param_4[0], param_5[0]);
    let _e13 = function_(param_4[1], param_5[1]);
    let _e14 = function_(param_4[2], param_5[2]);
    let _e18 = function_1(_e9, param_6[0]);
    let _e19 = function_1(_e10, param_6[1]);
    let _e20 = function_1(_e11, param_6[2]);
    let _e22 = function_(_e9, param_6[0]);
    let _e23 = function_(_e10, param_6[1]);
    let _e24 = function_(_e11, param_6[2]);
    let _e28 = function_1(_e12, param_6[0]);
    let _e29 = function_1(_e13, param_6[1]);
    let _e30 = function_1(_e14, param_6[2]);
    let _e31 = function_(_e12, param_6[0]);
    let _e32 = function_(_e13, param_6[1]);
    let _e33 = function_(_e14, param_6[2]);
    return type_28(array<f32, 3>(_e18, _e19, _e20), array<f32, 3>(_e31, _e32, _e33));
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_152_: u32;
    var phi_171_: u32;
    var phi_172_: array<u32, 3>;
    var phi_193_: u32;
    var phi_319_: type_28;
    var phi_320_: type_28;
    var phi_437_: type_28;
    var phi_513_: type_28;
    var phi_514_: type_28;
    var phi_515_: type_28;
    var phi_530_: type_13;
    var phi_533_: type_28;
    var phi_535_: u32;
    var phi_531_: type_13;
    var phi_576_: type_14;
    var phi_728_: type_28;
    var phi_729_: type_28;
    var phi_775_: type_28;
    var phi_788_: type_28;
    var phi_534_: type_28;
    var phi_536_: u32;
    var local: type_28;
    var local_1: type_28;
    var local_2: type_28;
    var local_3: type_28;
    var local_4: type_28;
    var local_5: type_28;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e34 = id_2;
    let _e35 = n_2;
    let _e36 = lane_2;
    let _e50 = ((((_e34.y * _e35.x) + _e34.x) * 256u) + _e36);
    let _e55 = params.member.member_2.member[0u][3u];
    let _e56 = (_e50 < _e55);
    let _e61 = params.member.member_2.member[0u][2u];
    if (_e50 >= _e61) {
        phi_152_ = 2u;
    } else {
        let _e64 = params.member.member_2.member[0u][1u];
        phi_152_ = select(0u, 1u, (_e50 >= _e64));
    }
    let _e68 = phi_152_;
    if _e56 {
        let _e70 = leaves.member[_e50];
        phi_171_ = _e70.w;
        phi_172_ = array<u32, 3>(_e70.x, _e70.y, _e70.z);
    } else {
        phi_171_ = 4294967295u;
        phi_172_ = array<u32, 3>(0u, 0u, 0u);
    }
    let _e77 = phi_171_;
    let _e79 = phi_172_;
    if (_e77 != 4294967295u) {
        let _e83 = params.member.member.member_1;
        let _e85 = ((_e83 & 1u) != 0u);
        if _e85 {
            phi_193_ = 0u;
        } else {
            let _e89 = params.member.member.member_2[_e68];
            phi_193_ = _e89;
        }
        let _e91 = phi_193_;
        let _e95 = boxes.member[(_e91 + _e79[0])];
        let _e110 = type_28(array<f32, 3>(_e95.member.x, _e95.member.y, _e95.member_1.x), array<f32, 3>(_e95.member_1.y, _e95.member_2.x, _e95.member_2.y));
        if _e85 {
            if (_e68 > 0u) {
                let _e115 = boxes.member[_e79[1]];
                let _e129 = select(_e115.member.x, _e95.member.x, (_e95.member.x < _e115.member.x));
                let _e131 = select(_e115.member.y, _e95.member.y, (_e95.member.y < _e115.member.y));
                let _e133 = select(_e115.member_1.x, _e95.member_1.x, (_e95.member_1.x < _e115.member_1.x));
                let _e135 = select(_e115.member_1.y, _e95.member_1.y, (_e95.member_1.y > _e115.member_1.y));
                let _e137 = select(_e115.member_2.x, _e95.member_2.x, (_e95.member_2.x > _e115.member_2.x));
                let _e139 = select(_e115.member_2.y, _e95.member_2.y, (_e95.member_2.y > _e115.member_2.y));
                let _e141 = boxes.member[_e79[2]];
                phi_319_ = type_28(array<f32, 3>(select(_e141.member.x, _e129, (_e129 < _e141.member.x)), select(_e141.member.y, _e131, (_e131 < _e141.member.y)), select(_e141.member_1.x, _e133, (_e133 < _e141.member_1.x))), array<f32, 3>(select(_e141.member_1.y, _e135, (_e135 > _e141.member_1.y)), select(_e141.member_2.x, _e137, (_e137 > _e141.member_2.x)), select(_e141.member_2.y, _e139, (_e139 > _e141.member_2.y))));
            } else {
                phi_319_ = _e110;
            }
            let _e170 = phi_319_;
            phi_320_ = _e170;
        } else {
            phi_320_ = _e110;
        }
        let _e172 = phi_320_;
        let _e175 = params.member.member.member_1;
        if ((_e175 & 512u) != 0u) {
            let _e180 = paths.member[_e79[0]];
            let _e201 = paths.member[_e79[1]];
            let _e222 = paths.member[_e79[2]];
            let _e241 = function_2(array<f32, 4>(_e180.member.x, _e180.member.y, _e180.member.z, _e180.member.w), array<f32, 4>(_e201.member.x, _e201.member.y, _e201.member.z, _e201.member.w), array<f32, 4>(_e222.member.x, _e222.member.y, _e222.member.z, _e222.member.w));
            let _e242 = function_2(array<f32, 4>(_e180.member_1.x, _e180.member_1.y, _e180.member_1.z, _e180.member_1.w), array<f32, 4>(_e201.member_1.x, _e201.member_1.y, _e201.member_1.z, _e201.member_1.w), array<f32, 4>(_e222.member_1.x, _e222.member_1.y, _e222.member_1.z, _e222.member_1.w));
            ends.member[(((_e50 / 32u) * 96u) + (_e50 % 32u))] = vec4<f32>(_e241.member[0], _e241.member[1], _e241.member[2], _e241.member_1[0]);
            ends.member[(((((_e50 / 32u) * 3u) + 1u) * 32u) + (_e50 % 32u))] = vec4<f32>(_e241.member_1[1], _e241.member_1[2], _e242.member[0], _e242.member[1]);
            ends.member[(((((_e50 / 32u) * 3u) + 2u) * 32u) + (_e50 % 32u))] = vec4<f32>(_e242.member[2], _e242.member_1[0], _e242.member_1[1], _e242.member_1[2]);
        }
        phi_437_ = _e172;
    } else {
        phi_437_ = type_28(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e282 = phi_437_;
    let _e285 = params.member.member.member_1;
    let _e287 = ((_e285 & 256u) != 0u);
    if _e287 {
        let _e290 = bodies.member[_e79[0]];
        if (_e282.member[0] <= _e282.member_1[0]) {
            if (((bitcast<u32>(_e282.member_1[0]) & 1u) == 1u) != ((_e290 & 1u) == 1u)) {
                let _e306 = bitcast<u32>(_e282.member_1[0]);
                let _e309 = ((_e306 >> bitcast<u32>(31i)) == 1u);
                let _e310 = (_e306 & 2147483647u);
                let _e311 = (_e310 < 8388608u);
                let _e314 = select(true, select(true, false, (_e310 == 8388608u)), _e309);
                phi_513_ = type_28(_e282.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e306 + 1u), (_e306 - 1u), _e309), _e314), u32(), _e311), (8388608u | ((_e306 & 1u) ^ 1u)), select(select(true, false, _e314), true, _e311))), _e282.member_1[1], _e282.member_1[2]));
            } else {
                phi_513_ = _e282;
            }
            let _e334 = phi_513_;
            phi_514_ = _e334;
        } else {
            phi_514_ = _e282;
        }
        let _e336 = phi_514_;
        phi_515_ = _e336;
    } else {
        phi_515_ = _e282;
    }
    let _e338 = phi_515_;
    shared_[_e36] = type_28(array<f32, 3>(_e338.member[0], _e338.member[1], _e338.member[2]), array<f32, 3>(_e338.member_1[0], _e338.member_1[1], _e338.member_1[2]));
    phi_530_ = type_13(0i, 5i);
    phi_533_ = _e338;
    phi_535_ = 16u;
    loop {
        let _e352 = phi_530_;
        let _e354 = phi_533_;
        let _e356 = phi_535_;
        local = _e354;
        local_1 = _e354;
        local_2 = _e354;
        local_3 = _e354;
        local_4 = _e354;
        local_5 = _e354;
        if (_e352.member < _e352.member_1) {
            let _e363 = (_e352.member + 1i);
            phi_531_ = type_13(select(_e363, type_14().member_1, select(false, true, ((false == (_e363 > _e352.member)) != false))), _e352.member_1);
            phi_576_ = type_14(1u, _e352.member);
        } else {
            phi_531_ = _e352;
            phi_576_ = type_14(0u, type_14().member_1);
        }
        let _e374 = phi_531_;
        let _e376 = phi_576_;
        let _e379 = (bitcast<i32>(_e376.member) != 0i);
        if _e379 {
            workgroupBarrier();
            if ((_e36 % 32u) < _e356) {
                let _e384 = shared_[(_e36 + _e356)];
                if _e287 {
                    let _e423 = select(_e384.member[0], _e354.member[0], (_e354.member[0] < _e384.member[0]));
                    let _e436 = select(_e384.member_1[0], _e354.member_1[0], (_e354.member_1[0] > _e384.member_1[0]));
                    let _e446 = type_28(array<f32, 3>(_e423, select(_e384.member[1], _e354.member[1], (_e354.member[1] < _e384.member[1])), select(_e384.member[2], _e354.member[2], (_e354.member[2] < _e384.member[2]))), array<f32, 3>(_e436, select(_e384.member_1[1], _e354.member_1[1], (_e354.member_1[1] > _e384.member_1[1])), select(_e384.member_1[2], _e354.member_1[2], (_e354.member_1[2] > _e384.member_1[2]))));
                    if (_e423 <= _e436) {
                        if (((bitcast<u32>(_e436) & 1u) == 1u) != select(false, select(!((_e384.member[0] <= _e384.member_1[0])), true, ((bitcast<u32>(_e384.member_1[0]) & 1u) == 1u)), select(!((_e354.member[0] <= _e354.member_1[0])), true, ((bitcast<u32>(_e354.member_1[0]) & 1u) == 1u)))) {
                            let _e471 = bitcast<u32>(_e436);
                            let _e474 = ((_e471 >> bitcast<u32>(31i)) == 1u);
                            let _e475 = (_e471 & 2147483647u);
                            let _e476 = (_e475 < 8388608u);
                            let _e479 = select(true, select(true, false, (_e475 == 8388608u)), _e474);
                            phi_728_ = type_28(_e446.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e471 + 1u), (_e471 - 1u), _e474), _e479), u32(), _e476), (8388608u | ((_e471 & 1u) ^ 1u)), select(select(true, false, _e479), true, _e476))), _e446.member_1[1], _e446.member_1[2]));
                        } else {
                            phi_728_ = _e446;
                        }
                        let _e499 = phi_728_;
                        phi_729_ = _e499;
                    } else {
                        phi_729_ = _e446;
                    }
                    let _e501 = phi_729_;
                    phi_775_ = _e501;
                } else {
                    phi_775_ = type_28(array<f32, 3>(select(_e384.member[0], _e354.member[0], (_e354.member[0] < _e384.member[0])), select(_e384.member[1], _e354.member[1], (_e354.member[1] < _e384.member[1])), select(_e384.member[2], _e354.member[2], (_e354.member[2] < _e384.member[2]))), array<f32, 3>(select(_e384.member_1[0], _e354.member_1[0], (_e354.member_1[0] > _e384.member_1[0])), select(_e384.member_1[1], _e354.member_1[1], (_e354.member_1[1] > _e384.member_1[1])), select(_e384.member_1[2], _e354.member_1[2], (_e354.member_1[2] > _e384.member_1[2]))));
                }
                let _e503 = phi_775_;
                shared_[_e36] = type_28(array<f32, 3>(_e503.member[0], _e503.member[1], _e503.member[2]), array<f32, 3>(_e503.member_1[0], _e503.member_1[1], _e503.member_1[2]));
                phi_788_ = _e503;
            } else {
                phi_788_ = _e354;
            }
            let _e517 = phi_788_;
            phi_534_ = _e517;
            phi_536_ = (_e356 / 2u);
        } else {
            phi_534_ = type_28();
            phi_536_ = u32();
        }
        let _e520 = phi_534_;
        let _e522 = phi_536_;
        continue;
        continuing {
            phi_530_ = _e374;
            phi_533_ = _e520;
            phi_535_ = _e522;
            break if !(_e379);
        }
    }
    if _e56 {
        nodes.member[_e50] = type_24(vec2<f32>(_e282.member[0], _e282.member[1]), vec2<f32>(_e282.member[2], _e282.member_1[0]), vec2<f32>(_e282.member_1[1], _e282.member_1[2]));
        if ((_e36 % 32u) == 0u) {
            let _e547 = params.member.member_2.member[0u][_e68];
            let _e554 = params.member.member_2.member[1u][_e68];
            let _e557 = local;
            let _e561 = local_1;
            let _e565 = local_2;
            let _e569 = local_3;
            let _e573 = local_4;
            let _e577 = local_5;
            nodes.member[(_e554 + ((_e50 - _e547) / 32u))] = type_24(vec2<f32>(_e557.member[0], _e561.member[1]), vec2<f32>(_e565.member[2], _e569.member_1[0]), vec2<f32>(_e573.member_1[1], _e577.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
