struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
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

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_23 {
    member: array<u32>,
}

struct type_27 {
    member: array<array<u32, 2>>,
}

struct type_31 {
    member: array<array<u32, 3>>,
}

struct type_33 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_36 {
    member: array<type_33>,
}

struct type_49 {
    member: i32,
    member_1: i32,
}

struct type_50 {
    member: u32,
    member_1: i32,
}

struct type_51 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(2) 
var<storage> order: type_23;
@group(0) @binding(3) 
var<storage> edges: type_27;
@group(0) @binding(4) 
var<storage> faces: type_31;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_19;
@group(0) @binding(6) 
var<storage, read_write> leaves: type_36;
var<workgroup> shared_: array<type_6, 256>;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var phi_136_: u32;
    var phi_137_: u32;
    var phi_250_: type_33;
    var phi_251_: type_33;
    var phi_252_: type_33;
    var phi_253_: type_6;
    var phi_254_: type_33;
    var phi_255_: type_6;
    var phi_256_: type_33;
    var phi_271_: type_49;
    var phi_274_: type_6;
    var phi_276_: u32;
    var phi_297_: bool;
    var phi_303_: type_50;
    var phi_272_: type_49;
    var phi_317_: type_50;
    var phi_367_: type_51;
    var phi_368_: type_51;
    var phi_391_: type_51;
    var phi_417_: f32;
    var phi_444_: f32;
    var phi_476_: type_6;
    var phi_275_: type_6;
    var phi_277_: u32;
    var local_2: type_6;

    let _e43 = id_1;
    let _e44 = n_1;
    let _e45 = lane_1;
    let _e59 = ((((_e43.y * _e44.x) + _e43.x) * 256u) + _e45);
    let _e63 = params.member.member_20[0u][2u];
    if (_e59 >= _e63) {
        phi_137_ = 2u;
    } else {
        let _e66 = params.member.member_20[0u][1u];
        if (_e59 >= _e66) {
            phi_136_ = 1u;
        } else {
            phi_136_ = 0u;
        }
        let _e69 = phi_136_;
        phi_137_ = _e69;
    }
    let _e71 = phi_137_;
    if (_e71 < 4u) {
    } else {
        return;
    }
    let _e76 = params.member.member_20[0u][_e71];
    let _e77 = (_e59 - _e76);
    let _e81 = params.member.member_20[0u][3u];
    let _e82 = (_e59 < _e81);
    if _e82 {
        if (_e71 < 3u) {
        } else {
            return;
        }
        let _e86 = params.member.member[_e71];
        if (_e77 < _e86) {
            if (_e71 < 4u) {
            } else {
                return;
            }
            let _e91 = params.member.member_2[_e71];
            let _e94 = order.member[(_e91 + _e77)];
            let _e96 = boxes.member[_e94];
            if (_e71 < 4u) {
            } else {
                return;
            }
            let _e100 = params.member.member_2[_e71];
            let _e101 = (_e94 - _e100);
            let _e102 = type_33(array<u32, 3>(0u, 0u, 0u), _e101);
            let _e109 = type_33(array<u32, 3>(_e101, _e102.member[1], _e102.member[2]), _e102.member_1);
            let _e116 = type_33(array<u32, 3>(_e109.member[0], _e101, _e109.member[2]), _e109.member_1);
            let _e120 = type_33(array<u32, 3>(_e101, _e101, _e101), _e116.member_1);
            let _e122 = params.member.member_1;
            if ((_e122 & 1u) != 0u) {
                if (_e71 == 1u) {
                    let _e135 = edges.member[_e101];
                    let _e145 = type_33(array<u32, 3>(_e135[0], _e120.member[1], _e120.member[2]), _e120.member_1);
                    let _e152 = type_33(array<u32, 3>(_e145.member[0], _e135[1], _e145.member[2]), _e145.member_1);
                    phi_251_ = type_33(array<u32, 3>(_e135[0], _e135[1], _e135[1]), _e152.member_1);
                } else {
                    if (_e71 == 2u) {
                        let _e128 = faces.member[_e101];
                        phi_250_ = type_33(_e128, _e120.member_1);
                    } else {
                        phi_250_ = _e120;
                    }
                    let _e133 = phi_250_;
                    phi_251_ = _e133;
                }
                let _e158 = phi_251_;
                phi_252_ = _e158;
            } else {
                phi_252_ = _e120;
            }
            let _e160 = phi_252_;
            phi_253_ = _e96;
            phi_254_ = _e160;
        } else {
            phi_253_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            phi_254_ = type_33(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        }
        let _e162 = phi_253_;
        let _e164 = phi_254_;
        phi_255_ = _e162;
        phi_256_ = _e164;
    } else {
        phi_255_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_256_ = type_33(array<u32, 3>(0u, 0u, 0u), 4294967295u);
    }
    let _e166 = phi_255_;
    let _e168 = phi_256_;
    shared_[_e45] = type_6(array<f32, 3>(_e166.member[0], _e166.member[1], _e166.member[2]), array<f32, 3>(_e166.member_1[0], _e166.member_1[1], _e166.member_1[2]));
    phi_271_ = type_49(0i, 5i);
    phi_274_ = _e166;
    phi_276_ = 16u;
    loop {
        let _e182 = phi_271_;
        let _e184 = phi_274_;
        let _e186 = phi_276_;
        local_2 = _e184;
        if (_e182.member < _e182.member_1) {
            let _e194 = (_e182.member + 1i);
            if ((false == (_e194 > _e182.member)) != false) {
                phi_297_ = true;
            } else {
                phi_297_ = false;
            }
            let _e199 = phi_297_;
            if _e199 {
                phi_303_ = type_50(0u, type_50().member_1);
            } else {
                phi_303_ = type_50(1u, _e194);
            }
            let _e205 = phi_303_;
            if (bitcast<i32>(_e205.member) != 0i) {
            } else {
                return;
            }
            phi_272_ = type_49(_e205.member_1, _e182.member_1);
            phi_317_ = type_50(1u, _e182.member);
        } else {
            phi_272_ = _e182;
            phi_317_ = type_50(0u, type_50().member_1);
        }
        let _e215 = phi_272_;
        let _e217 = phi_317_;
        let _e220 = (bitcast<i32>(_e217.member) != 0i);
        if _e220 {
            workgroupBarrier();
            if ((_e45 % 32u) < _e186) {
                let _e225 = shared_[(_e45 + _e186)];
                local_1 = _e225;
                local = type_6(array<f32, 3>(_e184.member[0], _e184.member[1], _e184.member[2]), array<f32, 3>(_e184.member_1[0], _e184.member_1[1], _e184.member_1[2]));
                phi_367_ = type_51(0u, 3u);
                loop {
                    let _e238 = phi_367_;
                    if (_e238.member < _e238.member_1) {
                        phi_368_ = type_51((_e238.member + 1u), _e238.member_1);
                        phi_391_ = type_51(1u, _e238.member);
                    } else {
                        phi_368_ = _e238;
                        phi_391_ = type_51(0u, type_51().member_1);
                    }
                    let _e252 = phi_368_;
                    let _e254 = phi_391_;
                    let _e258 = (bitcast<i32>(_e254.member) != 0i);
                    if _e258 {
                        if (_e254.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e262 = local.member[_e254.member_1];
                        if (_e254.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e266 = local_1.member[_e254.member_1];
                        if (_e262 < _e266) {
                            phi_417_ = _e262;
                        } else {
                            phi_417_ = _e266;
                        }
                        let _e269 = phi_417_;
                        if (_e254.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member[_e254.member_1] = _e269;
                        if (_e254.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e276 = local.member_1[_e254.member_1];
                        if (_e254.member_1 < 3u) {
                        } else {
                            return;
                        }
                        let _e280 = local_1.member_1[_e254.member_1];
                        if (_e276 > _e280) {
                            phi_444_ = _e276;
                        } else {
                            phi_444_ = _e280;
                        }
                        let _e283 = phi_444_;
                        if (_e254.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member_1[_e254.member_1] = _e283;
                    }
                    continue;
                    continuing {
                        phi_367_ = _e252;
                        break if !(_e258);
                    }
                }
                let _e288 = local;
                shared_[_e45] = _e288;
                phi_476_ = type_6(array<f32, 3>(_e288.member[0], _e288.member[1], _e288.member[2]), array<f32, 3>(_e288.member_1[0], _e288.member_1[1], _e288.member_1[2]));
            } else {
                phi_476_ = _e184;
            }
            let _e302 = phi_476_;
            phi_275_ = _e302;
            phi_277_ = (_e186 / 2u);
        } else {
            phi_275_ = type_6();
            phi_277_ = u32();
        }
        let _e305 = phi_275_;
        let _e307 = phi_277_;
        continue;
        continuing {
            phi_271_ = _e215;
            phi_274_ = _e305;
            phi_276_ = _e307;
            break if !(_e220);
        }
    }
    if _e82 {
        nodes.member[_e59] = _e166;
        leaves.member[_e59] = _e168;
        if ((_e45 % 32u) == 0u) {
            if (_e71 < 4u) {
            } else {
                return;
            }
            let _e318 = params.member.member_20[1u][_e71];
            let _e322 = local_2;
            nodes.member[(_e318 + (_e77 / 32u))] = _e322;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_leaves(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
