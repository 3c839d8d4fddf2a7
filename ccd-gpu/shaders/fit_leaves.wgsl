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

struct type_19 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: array<vec4<u32>>,
}

struct type_26 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_33 {
    member: array<array<u32, 3>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage> order: type_10;
@group(0) @binding(1) 
var<storage> boxes: type_28;
var<workgroup> shared_: array<type_30, 256>;
@group(0) @binding(3) 
var<storage> edges: type_21;
@group(0) @binding(4) 
var<storage> faces: type_33;
@group(0) @binding(5) 
var<storage> bodies: type_10;
@group(0) @binding(6) 
var<storage, read_write> nodes: type_28;
@group(0) @binding(7) 
var<storage, read_write> leaves: type_24;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_143_: u32;
    var phi_266_: type_19;
    var phi_267_: type_19;
    var phi_268_: type_19;
    var phi_269_: type_19;
    var phi_270_: type_30;
    var phi_271_: type_19;
    var phi_272_: type_30;
    var phi_348_: type_30;
    var phi_349_: type_30;
    var phi_350_: type_30;
    var phi_365_: type_13;
    var phi_368_: type_30;
    var phi_370_: u32;
    var phi_366_: type_13;
    var phi_411_: type_14;
    var phi_563_: type_30;
    var phi_564_: type_30;
    var phi_610_: type_30;
    var phi_623_: type_30;
    var phi_369_: type_30;
    var phi_371_: u32;
    var local: type_30;
    var local_1: type_30;
    var local_2: type_30;
    var local_3: type_30;
    var local_4: type_30;
    var local_5: type_30;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e50 = ((((_e33.y * _e34.x) + _e33.x) * 256u) + _e35);
    let _e55 = params.member.member_2.member[0u][2u];
    if (_e50 >= _e55) {
        phi_143_ = 2u;
    } else {
        let _e58 = params.member.member_2.member[0u][1u];
        phi_143_ = select(0u, 1u, (_e50 >= _e58));
    }
    let _e62 = phi_143_;
    let _e67 = params.member.member_2.member[0u][_e62];
    let _e68 = (_e50 - _e67);
    let _e73 = params.member.member_2.member[0u][3u];
    let _e74 = (_e50 < _e73);
    if _e74 {
        let _e78 = params.member.member.member[_e62];
        if (_e68 < _e78) {
            let _e83 = params.member.member.member_2[_e62];
            let _e86 = order.member[(_e83 + _e68)];
            let _e88 = boxes.member[_e86];
            let _e107 = params.member.member.member_2[_e62];
            let _e108 = (_e86 - _e107);
            let _e112 = type_19(array<u32, 3>(_e108, _e108, _e108), type_19(array<u32, 3>(0u, 0u, 0u), _e108).member_1);
            let _e115 = params.member.member.member_1;
            if ((_e115 & 1u) != 0u) {
                if (_e62 == 1u) {
                    let _e127 = edges.member[_e108];
                    phi_267_ = type_19(array<u32, 3>(_e127[0], _e127[1], _e127[1]), _e112.member_1);
                } else {
                    if (_e62 == 2u) {
                        let _e121 = faces.member[_e108];
                        phi_266_ = type_19(_e121, _e112.member_1);
                    } else {
                        phi_266_ = _e112;
                    }
                    let _e125 = phi_266_;
                    phi_267_ = _e125;
                }
                let _e135 = phi_267_;
                phi_268_ = _e135;
            } else {
                phi_268_ = _e112;
            }
            let _e137 = phi_268_;
            phi_269_ = _e137;
            phi_270_ = type_30(array<f32, 3>(_e88.member.x, _e88.member.y, _e88.member_1.x), array<f32, 3>(_e88.member_1.y, _e88.member_2.x, _e88.member_2.y));
        } else {
            phi_269_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
            phi_270_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        }
        let _e139 = phi_269_;
        let _e141 = phi_270_;
        phi_271_ = _e139;
        phi_272_ = _e141;
    } else {
        phi_271_ = type_19(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        phi_272_ = type_30(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e143 = phi_271_;
    let _e145 = phi_272_;
    let _e148 = params.member.member.member_1;
    let _e150 = ((_e148 & 256u) != 0u);
    if _e150 {
        let _e154 = bodies.member[_e143.member[0]];
        if (_e145.member[0] <= _e145.member_1[0]) {
            if (((bitcast<u32>(_e145.member_1[0]) & 1u) == 1u) != ((_e154 & 1u) == 1u)) {
                let _e170 = bitcast<u32>(_e145.member_1[0]);
                let _e173 = ((_e170 >> bitcast<u32>(31i)) == 1u);
                let _e174 = (_e170 & 2147483647u);
                let _e175 = (_e174 < 8388608u);
                let _e178 = select(true, select(true, false, (_e174 == 8388608u)), _e173);
                phi_348_ = type_30(_e145.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e170 + 1u), (_e170 - 1u), _e173), _e178), u32(), _e175), (8388608u | ((_e170 & 1u) ^ 1u)), select(select(true, false, _e178), true, _e175))), _e145.member_1[1], _e145.member_1[2]));
            } else {
                phi_348_ = _e145;
            }
            let _e198 = phi_348_;
            phi_349_ = _e198;
        } else {
            phi_349_ = _e145;
        }
        let _e200 = phi_349_;
        phi_350_ = _e200;
    } else {
        phi_350_ = _e145;
    }
    let _e202 = phi_350_;
    shared_[_e35] = type_30(array<f32, 3>(_e202.member[0], _e202.member[1], _e202.member[2]), array<f32, 3>(_e202.member_1[0], _e202.member_1[1], _e202.member_1[2]));
    phi_365_ = type_13(0i, 5i);
    phi_368_ = _e202;
    phi_370_ = 16u;
    loop {
        let _e216 = phi_365_;
        let _e218 = phi_368_;
        let _e220 = phi_370_;
        local = _e218;
        local_1 = _e218;
        local_2 = _e218;
        local_3 = _e218;
        local_4 = _e218;
        local_5 = _e218;
        if (_e216.member < _e216.member_1) {
            let _e227 = (_e216.member + 1i);
            phi_366_ = type_13(select(_e227, type_14().member_1, select(false, true, ((false == (_e227 > _e216.member)) != false))), _e216.member_1);
            phi_411_ = type_14(1u, _e216.member);
        } else {
            phi_366_ = _e216;
            phi_411_ = type_14(0u, type_14().member_1);
        }
        let _e238 = phi_366_;
        let _e240 = phi_411_;
        let _e243 = (bitcast<i32>(_e240.member) != 0i);
        if _e243 {
            workgroupBarrier();
            if ((_e35 % 32u) < _e220) {
                let _e248 = shared_[(_e35 + _e220)];
                if _e150 {
                    let _e287 = select(_e248.member[0], _e218.member[0], (_e218.member[0] < _e248.member[0]));
                    let _e300 = select(_e248.member_1[0], _e218.member_1[0], (_e218.member_1[0] > _e248.member_1[0]));
                    let _e310 = type_30(array<f32, 3>(_e287, select(_e248.member[1], _e218.member[1], (_e218.member[1] < _e248.member[1])), select(_e248.member[2], _e218.member[2], (_e218.member[2] < _e248.member[2]))), array<f32, 3>(_e300, select(_e248.member_1[1], _e218.member_1[1], (_e218.member_1[1] > _e248.member_1[1])), select(_e248.member_1[2], _e218.member_1[2], (_e218.member_1[2] > _e248.member_1[2]))));
                    if (_e287 <= _e300) {
                        if (((bitcast<u32>(_e300) & 1u) == 1u) != select(false, select(!((_e248.member[0] <= _e248.member_1[0])), true, ((bitcast<u32>(_e248.member_1[0]) & 1u) == 1u)), select(!((_e218.member[0] <= _e218.member_1[0])), true, ((bitcast<u32>(_e218.member_1[0]) & 1u) == 1u)))) {
                            let _e335 = bitcast<u32>(_e300);
                            let _e338 = ((_e335 >> bitcast<u32>(31i)) == 1u);
                            let _e339 = (_e335 & 2147483647u);
                            let _e340 = (_e339 < 8388608u);
                            let _e343 = select(true, select(true, false, (_e339 == 8388608u)), _e338);
                            phi_563_ = type_30(_e310.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e335 + 1u), (_e335 - 1u), _e338), _e343), u32(), _e340), (8388608u | ((_e335 & 1u) ^ 1u)), select(select(true, false, _e343), true, _e340))), _e310.member_1[1], _e310.member_1[2]));
                        } else {
                            phi_563_ = _e310;
                        }
                        let _e363 = phi_563_;
                        phi_564_ = _e363;
                    } else {
                        phi_564_ = _e310;
                    }
                    let _e365 = phi_564_;
                    phi_610_ = _e365;
                } else {
                    phi_610_ = type_30(array<f32, 3>(select(_e248.member[0], _e218.member[0], (_e218.member[0] < _e248.member[0])), select(_e248.member[1], _e218.member[1], (_e218.member[1] < _e248.member[1])), select(_e248.member[2], _e218.member[2], (_e218.member[2] < _e248.member[2]))), array<f32, 3>(select(_e248.member_1[0], _e218.member_1[0], (_e218.member_1[0] > _e248.member_1[0])), select(_e248.member_1[1], _e218.member_1[1], (_e218.member_1[1] > _e248.member_1[1])), select(_e248.member_1[2], _e218.member_1[2], (_e218.member_1[2] > _e248.member_1[2]))));
                }
                let _e367 = phi_610_;
                shared_[_e35] = type_30(array<f32, 3>(_e367.member[0], _e367.member[1], _e367.member[2]), array<f32, 3>(_e367.member_1[0], _e367.member_1[1], _e367.member_1[2]));
                phi_623_ = _e367;
            } else {
                phi_623_ = _e218;
            }
            let _e381 = phi_623_;
            phi_369_ = _e381;
            phi_371_ = (_e220 / 2u);
        } else {
            phi_369_ = type_30();
            phi_371_ = u32();
        }
        let _e384 = phi_369_;
        let _e386 = phi_371_;
        continue;
        continuing {
            phi_365_ = _e238;
            phi_368_ = _e384;
            phi_370_ = _e386;
            break if !(_e243);
        }
    }
    if _e74 {
        nodes.member[_e50] = type_26(vec2<f32>(_e145.member[0], _e145.member[1]), vec2<f32>(_e145.member[2], _e145.member_1[0]), vec2<f32>(_e145.member_1[1], _e145.member_1[2]));
        leaves.member[_e50] = vec4<u32>(_e143.member[0], _e143.member[1], _e143.member[2], _e143.member_1);
        if ((_e35 % 32u) == 0u) {
            let _e421 = params.member.member_2.member[1u][_e62];
            let _e424 = local;
            let _e428 = local_1;
            let _e432 = local_2;
            let _e436 = local_3;
            let _e440 = local_4;
            let _e444 = local_5;
            nodes.member[(_e421 + (_e68 / 32u))] = type_26(vec2<f32>(_e424.member[0], _e428.member[1]), vec2<f32>(_e432.member[2], _e436.member_1[0]), vec2<f32>(_e440.member_1[1], _e444.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
