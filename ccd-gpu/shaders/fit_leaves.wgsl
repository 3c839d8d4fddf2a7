struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_10 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
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
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
}

struct type_15 {
    member: array<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
}

struct type_19 {
    member: array<array<u32, 3>>,
}

struct type_20 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_26 {
    member: i32,
    member_1: i32,
}

struct type_27 {
    member: u32,
    member_1: i32,
}

struct type_28 {
    member: u32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_13;
@group(0) @binding(2) 
var<storage> order: type_15;
@group(0) @binding(3) 
var<storage> edges: type_17;
@group(0) @binding(4) 
var<storage> faces: type_19;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_13;
@group(0) @binding(6) 
var<storage, read_write> leaves: type_22;
var<workgroup> shared_: array<type_4, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var phi_136_: u32;
    var phi_137_: u32;
    var phi_250_: type_20;
    var phi_251_: type_20;
    var phi_252_: type_20;
    var phi_253_: type_4;
    var phi_254_: type_20;
    var phi_255_: type_4;
    var phi_256_: type_20;
    var phi_271_: type_26;
    var phi_274_: type_4;
    var phi_276_: u32;
    var phi_297_: bool;
    var phi_303_: type_27;
    var phi_272_: type_26;
    var phi_317_: type_27;
    var phi_367_: type_28;
    var phi_368_: type_28;
    var phi_391_: type_28;
    var phi_417_: f32;
    var phi_444_: f32;
    var phi_476_: type_4;
    var phi_275_: type_4;
    var phi_277_: u32;
    var local_2: type_4;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e49 = ((((_e33.y * _e34.x) + _e33.x) * 256u) + _e35);
    let _e53 = params.member.member_20[0u][2u];
    if (_e49 >= _e53) {
        phi_137_ = 2u;
    } else {
        let _e56 = params.member.member_20[0u][1u];
        if (_e49 >= _e56) {
            phi_136_ = 1u;
        } else {
            phi_136_ = 0u;
        }
        let _e59 = phi_136_;
        phi_137_ = _e59;
    }
    let _e61 = phi_137_;
    let _e65 = params.member.member_20[0u][_e61];
    let _e66 = (_e49 - _e65);
    let _e70 = params.member.member_20[0u][3u];
    let _e71 = (_e49 < _e70);
    if _e71 {
        let _e74 = params.member.member[_e61];
        if (_e66 < _e74) {
            let _e78 = params.member.member_2[_e61];
            let _e81 = order.member[(_e78 + _e66)];
            let _e83 = boxes.member[_e81];
            let _e86 = params.member.member_2[_e61];
            let _e87 = (_e81 - _e86);
            let _e88 = type_20(array<u32, 3>(0u, 0u, 0u), _e87);
            let _e94 = type_20(array<u32, 3>(_e87, _e88.member[1], _e88.member[2]), _e88.member_1);
            let _e103 = type_20(array<u32, 3>(_e87, _e87, _e87), type_20(array<u32, 3>(_e94.member[0], _e87, _e94.member[2]), _e94.member_1).member_1);
            let _e105 = params.member.member_1;
            if ((_e105 & 1u) != 0u) {
                if (_e61 == 1u) {
                    let _e117 = edges.member[_e87];
                    let _e126 = type_20(array<u32, 3>(_e117[0], _e103.member[1], _e103.member[2]), _e103.member_1);
                    phi_251_ = type_20(array<u32, 3>(_e117[0], _e117[1], _e117[1]), type_20(array<u32, 3>(_e126.member[0], _e117[1], _e126.member[2]), _e126.member_1).member_1);
                } else {
                    if (_e61 == 2u) {
                        let _e111 = faces.member[_e87];
                        phi_250_ = type_20(_e111, _e103.member_1);
                    } else {
                        phi_250_ = _e103;
                    }
                    let _e115 = phi_250_;
                    phi_251_ = _e115;
                }
                let _e137 = phi_251_;
                phi_252_ = _e137;
            } else {
                phi_252_ = _e103;
            }
            let _e139 = phi_252_;
            phi_253_ = _e83;
            phi_254_ = _e139;
        } else {
            phi_253_ = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            phi_254_ = type_20(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        }
        let _e141 = phi_253_;
        let _e143 = phi_254_;
        phi_255_ = _e141;
        phi_256_ = _e143;
    } else {
        phi_255_ = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_256_ = type_20(array<u32, 3>(0u, 0u, 0u), 4294967295u);
    }
    let _e145 = phi_255_;
    let _e147 = phi_256_;
    shared_[_e35] = type_4(array<f32, 3>(_e145.member[0], _e145.member[1], _e145.member[2]), array<f32, 3>(_e145.member_1[0], _e145.member_1[1], _e145.member_1[2]));
    phi_271_ = type_26(0i, 5i);
    phi_274_ = _e145;
    phi_276_ = 16u;
    loop {
        let _e161 = phi_271_;
        let _e163 = phi_274_;
        let _e165 = phi_276_;
        local_2 = _e163;
        if (_e161.member < _e161.member_1) {
            let _e172 = (_e161.member + 1i);
            if ((false == (_e172 > _e161.member)) != false) {
                phi_297_ = true;
            } else {
                phi_297_ = false;
            }
            let _e177 = phi_297_;
            if _e177 {
                phi_303_ = type_27(0u, type_27().member_1);
            } else {
                phi_303_ = type_27(1u, _e172);
            }
            let _e182 = phi_303_;
            phi_272_ = type_26(_e182.member_1, _e161.member_1);
            phi_317_ = type_27(1u, _e161.member);
        } else {
            phi_272_ = _e161;
            phi_317_ = type_27(0u, type_27().member_1);
        }
        let _e188 = phi_272_;
        let _e190 = phi_317_;
        let _e193 = (bitcast<i32>(_e190.member) != 0i);
        if _e193 {
            workgroupBarrier();
            if ((_e35 % 32u) < _e165) {
                let _e198 = shared_[(_e35 + _e165)];
                local_1 = _e198;
                local = type_4(array<f32, 3>(_e163.member[0], _e163.member[1], _e163.member[2]), array<f32, 3>(_e163.member_1[0], _e163.member_1[1], _e163.member_1[2]));
                phi_367_ = type_28(0u, 3u);
                loop {
                    let _e211 = phi_367_;
                    if (_e211.member < _e211.member_1) {
                        phi_368_ = type_28((_e211.member + 1u), _e211.member_1);
                        phi_391_ = type_28(1u, _e211.member);
                    } else {
                        phi_368_ = _e211;
                        phi_391_ = type_28(0u, type_28().member_1);
                    }
                    let _e223 = phi_368_;
                    let _e225 = phi_391_;
                    let _e229 = (bitcast<i32>(_e225.member) != 0i);
                    if _e229 {
                        let _e232 = local.member[_e225.member_1];
                        let _e235 = local_1.member[_e225.member_1];
                        if (_e232 < _e235) {
                            phi_417_ = _e232;
                        } else {
                            phi_417_ = _e235;
                        }
                        let _e238 = phi_417_;
                        local.member[_e225.member_1] = _e238;
                        let _e243 = local.member_1[_e225.member_1];
                        let _e246 = local_1.member_1[_e225.member_1];
                        if (_e243 > _e246) {
                            phi_444_ = _e243;
                        } else {
                            phi_444_ = _e246;
                        }
                        let _e249 = phi_444_;
                        local.member_1[_e225.member_1] = _e249;
                    }
                    continue;
                    continuing {
                        phi_367_ = _e223;
                        break if !(_e229);
                    }
                }
                let _e253 = local;
                shared_[_e35] = _e253;
                phi_476_ = type_4(array<f32, 3>(_e253.member[0], _e253.member[1], _e253.member[2]), array<f32, 3>(_e253.member_1[0], _e253.member_1[1], _e253.member_1[2]));
            } else {
                phi_476_ = _e163;
            }
            let _e267 = phi_476_;
            phi_275_ = _e267;
            phi_277_ = (_e165 / 2u);
        } else {
            phi_275_ = type_4();
            phi_277_ = u32();
        }
        let _e270 = phi_275_;
        let _e272 = phi_277_;
        continue;
        continuing {
            phi_271_ = _e188;
            phi_274_ = _e270;
            phi_276_ = _e272;
            break if !(_e193);
        }
    }
    if _e71 {
        nodes.member[_e49] = _e145;
        leaves.member[_e49] = _e147;
        if ((_e35 % 32u) == 0u) {
            let _e282 = params.member.member_20[1u][_e61];
            let _e286 = local_2;
            nodes.member[(_e282 + (_e66 / 32u))] = _e286;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
