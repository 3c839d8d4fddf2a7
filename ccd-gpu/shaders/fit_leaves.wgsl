struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_12 {
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
    member_18: array<array<u32, 4>, 8>,
}

struct type_14 {
    member: type_12,
}

struct type_18 {
    member: array<type_6>,
}

struct type_22 {
    member: array<u32>,
}

struct type_26 {
    member: array<array<u32, 2>>,
}

struct type_30 {
    member: array<array<u32, 3>>,
}

struct type_32 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_35 {
    member: array<type_32>,
}

struct type_48 {
    member: i32,
    member_1: i32,
}

struct type_49 {
    member: u32,
    member_1: i32,
}

struct type_50 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(1) 
var<storage> boxes: type_18;
@group(0) @binding(2) 
var<storage> order: type_22;
@group(0) @binding(3) 
var<storage> edges: type_26;
@group(0) @binding(4) 
var<storage> faces: type_30;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_18;
@group(0) @binding(6) 
var<storage, read_write> leaves: type_35;
var<workgroup> shared_: array<type_6, 256>;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var phi_135_: u32;
    var phi_136_: u32;
    var phi_249_: type_32;
    var phi_250_: type_32;
    var phi_251_: type_32;
    var phi_252_: type_6;
    var phi_253_: type_32;
    var phi_254_: type_6;
    var phi_255_: type_32;
    var phi_270_: type_48;
    var phi_273_: type_6;
    var phi_275_: u32;
    var phi_296_: bool;
    var phi_302_: type_49;
    var phi_271_: type_48;
    var phi_316_: type_49;
    var phi_366_: type_50;
    var phi_367_: type_50;
    var phi_390_: type_50;
    var phi_416_: f32;
    var phi_443_: f32;
    var phi_475_: type_6;
    var phi_274_: type_6;
    var phi_276_: u32;
    var local_2: type_6;

    let _e43 = id_1;
    let _e44 = n_1;
    let _e45 = lane_1;
    let _e59 = ((((_e43.y * _e44.x) + _e43.x) * 256u) + _e45);
    let _e63 = params.member.member_18[0u][2u];
    if (_e59 >= _e63) {
        phi_136_ = 2u;
    } else {
        let _e66 = params.member.member_18[0u][1u];
        if (_e59 >= _e66) {
            phi_135_ = 1u;
        } else {
            phi_135_ = 0u;
        }
        let _e69 = phi_135_;
        phi_136_ = _e69;
    }
    let _e71 = phi_136_;
    if (_e71 < 4u) {
    } else {
        return;
    }
    let _e76 = params.member.member_18[0u][_e71];
    let _e77 = (_e59 - _e76);
    let _e81 = params.member.member_18[0u][3u];
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
            let _e102 = type_32(array<u32, 3>(0u, 0u, 0u), _e101);
            let _e109 = type_32(array<u32, 3>(_e101, _e102.member[1], _e102.member[2]), _e102.member_1);
            let _e116 = type_32(array<u32, 3>(_e109.member[0], _e101, _e109.member[2]), _e109.member_1);
            let _e120 = type_32(array<u32, 3>(_e101, _e101, _e101), _e116.member_1);
            let _e122 = params.member.member_1;
            if ((_e122 & 1u) != 0u) {
                if (_e71 == 1u) {
                    let _e135 = edges.member[_e101];
                    let _e145 = type_32(array<u32, 3>(_e135[0], _e120.member[1], _e120.member[2]), _e120.member_1);
                    let _e152 = type_32(array<u32, 3>(_e145.member[0], _e135[1], _e145.member[2]), _e145.member_1);
                    phi_250_ = type_32(array<u32, 3>(_e135[0], _e135[1], _e135[1]), _e152.member_1);
                } else {
                    if (_e71 == 2u) {
                        let _e128 = faces.member[_e101];
                        phi_249_ = type_32(_e128, _e120.member_1);
                    } else {
                        phi_249_ = _e120;
                    }
                    let _e133 = phi_249_;
                    phi_250_ = _e133;
                }
                let _e158 = phi_250_;
                phi_251_ = _e158;
            } else {
                phi_251_ = _e120;
            }
            let _e160 = phi_251_;
            phi_252_ = _e96;
            phi_253_ = _e160;
        } else {
            phi_252_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            phi_253_ = type_32(array<u32, 3>(0u, 0u, 0u), 4294967295u);
        }
        let _e162 = phi_252_;
        let _e164 = phi_253_;
        phi_254_ = _e162;
        phi_255_ = _e164;
    } else {
        phi_254_ = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_255_ = type_32(array<u32, 3>(0u, 0u, 0u), 4294967295u);
    }
    let _e166 = phi_254_;
    let _e168 = phi_255_;
    shared_[_e45] = type_6(array<f32, 3>(_e166.member[0], _e166.member[1], _e166.member[2]), array<f32, 3>(_e166.member_1[0], _e166.member_1[1], _e166.member_1[2]));
    phi_270_ = type_48(0i, 5i);
    phi_273_ = _e166;
    phi_275_ = 16u;
    loop {
        let _e182 = phi_270_;
        let _e184 = phi_273_;
        let _e186 = phi_275_;
        local_2 = _e184;
        if (_e182.member < _e182.member_1) {
            let _e194 = (_e182.member + 1i);
            if ((false == (_e194 > _e182.member)) != false) {
                phi_296_ = true;
            } else {
                phi_296_ = false;
            }
            let _e199 = phi_296_;
            if _e199 {
                phi_302_ = type_49(0u, type_49().member_1);
            } else {
                phi_302_ = type_49(1u, _e194);
            }
            let _e205 = phi_302_;
            if (bitcast<i32>(_e205.member) != 0i) {
            } else {
                return;
            }
            phi_271_ = type_48(_e205.member_1, _e182.member_1);
            phi_316_ = type_49(1u, _e182.member);
        } else {
            phi_271_ = _e182;
            phi_316_ = type_49(0u, type_49().member_1);
        }
        let _e215 = phi_271_;
        let _e217 = phi_316_;
        let _e220 = (bitcast<i32>(_e217.member) != 0i);
        if _e220 {
            workgroupBarrier();
            if ((_e45 % 32u) < _e186) {
                let _e225 = shared_[(_e45 + _e186)];
                local_1 = _e225;
                local = type_6(array<f32, 3>(_e184.member[0], _e184.member[1], _e184.member[2]), array<f32, 3>(_e184.member_1[0], _e184.member_1[1], _e184.member_1[2]));
                phi_366_ = type_50(0u, 3u);
                loop {
                    let _e238 = phi_366_;
                    if (_e238.member < _e238.member_1) {
                        phi_367_ = type_50((_e238.member + 1u), _e238.member_1);
                        phi_390_ = type_50(1u, _e238.member);
                    } else {
                        phi_367_ = _e238;
                        phi_390_ = type_50(0u, type_50().member_1);
                    }
                    let _e252 = phi_367_;
                    let _e254 = phi_390_;
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
                            phi_416_ = _e262;
                        } else {
                            phi_416_ = _e266;
                        }
                        let _e269 = phi_416_;
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
                            phi_443_ = _e276;
                        } else {
                            phi_443_ = _e280;
                        }
                        let _e283 = phi_443_;
                        if (_e254.member_1 < 3u) {
                        } else {
                            return;
                        }
                        local.member_1[_e254.member_1] = _e283;
                    }
                    continue;
                    continuing {
                        phi_366_ = _e252;
                        break if !(_e258);
                    }
                }
                let _e288 = local;
                shared_[_e45] = _e288;
                phi_475_ = type_6(array<f32, 3>(_e288.member[0], _e288.member[1], _e288.member[2]), array<f32, 3>(_e288.member_1[0], _e288.member_1[1], _e288.member_1[2]));
            } else {
                phi_475_ = _e184;
            }
            let _e302 = phi_475_;
            phi_274_ = _e302;
            phi_276_ = (_e186 / 2u);
        } else {
            phi_274_ = type_6();
            phi_276_ = u32();
        }
        let _e305 = phi_274_;
        let _e307 = phi_276_;
        continue;
        continuing {
            phi_270_ = _e215;
            phi_273_ = _e305;
            phi_275_ = _e307;
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
            let _e318 = params.member.member_18[1u][_e71];
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
