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

struct type_15 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_8>,
}

struct type_23 {
    member: array<type_19>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_26 {
    member: array<type_24>,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> branches: type_21;
@group(0) @binding(2) 
var<storage> block_nodes: type_23;
@group(0) @binding(3) 
var<storage> order: type_11;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_26;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_126_: type_9;
    var phi_129_: type_19;
    var phi_131_: u32;
    var phi_133_: u32;
    var phi_185_: bool;
    var phi_210_: type_9;
    var phi_213_: type_19;
    var phi_214_: type_19;
    var phi_505_: type_9;
    var phi_508_: type_19;
    var phi_509_: type_19;
    var phi_785_: u32;
    var phi_790_: u32;
    var phi_130_: type_19;
    var phi_132_: u32;
    var phi_134_: u32;
    var local: type_19;
    var local_1: type_19;
    var local_2: type_19;
    var local_3: type_19;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e37 = ((((_e23.y * _e24.x) + _e23.x) * 256u) + _e25);
    let _e40 = params.member.member_2.member_1;
    let _e44 = params.member.member.member[_e40];
    if ((_e37 + 1u) < _e44) {
        let _e48 = branches.member[_e37];
        phi_126_ = type_9(0u, 8u);
        phi_129_ = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_131_ = (_e48.member_3 + 1u);
        phi_133_ = _e48.member_2;
        loop {
            let _e54 = phi_126_;
            let _e56 = phi_129_;
            let _e58 = phi_131_;
            let _e60 = phi_133_;
            local = _e56;
            local_1 = _e56;
            let _e63 = (_e54.member < _e54.member_1);
            let _e74 = select(type_9().member_1, _e54.member, _e63);
            let _e76 = (bitcast<i32>(select(0u, 1u, _e63)) != 0i);
            if _e76 {
                let _e77 = (_e60 % 32u);
                let _e81 = select((_e60 + (32u - _e77)), _e60, (_e77 == 0u));
                let _e83 = ((_e58 / 32u) * 32u);
                if (_e81 < _e83) {
                    let _e86 = params.member.member_2.member_2;
                    phi_185_ = (_e74 < _e86);
                } else {
                    phi_185_ = false;
                }
                let _e89 = phi_185_;
                let _e90 = select(_e58, _e83, _e89);
                let _e91 = select(_e58, _e81, _e89);
                let _e92 = (_e91 - _e60);
                let _e93 = (_e92 / 4u);
                phi_210_ = type_9(0u, select(_e93, (_e93 + 1u), ((_e92 % 4u) > 0u)));
                phi_213_ = _e56;
                loop {
                    let _e100 = phi_210_;
                    let _e102 = phi_213_;
                    local_2 = _e102;
                    let _e105 = (_e100.member < _e100.member_1);
                    let _e118 = (bitcast<i32>(select(0u, 1u, _e105)) != 0i);
                    if _e118 {
                        let _e124 = params.member.member_2.member[_e74][_e40];
                        let _e125 = (_e124 + (_e60 + (4u * select(type_9().member_1, _e100.member, _e105))));
                        let _e129 = params.member.member_2.member[_e74][_e40];
                        let _e131 = ((_e129 + _e91) - 1u);
                        let _e133 = block_nodes.member[_e125];
                        let _e134 = (_e125 + 1u);
                        let _e138 = block_nodes.member[select(_e134, _e131, (_e131 < _e134))];
                        let _e139 = (_e125 + 2u);
                        let _e143 = block_nodes.member[select(_e139, _e131, (_e131 < _e139))];
                        let _e144 = (_e125 + 3u);
                        let _e148 = block_nodes.member[select(_e144, _e131, (_e131 < _e144))];
                        let _e154 = select(_e138.member[0], _e133.member[0], (_e133.member[0] < _e138.member[0]));
                        let _e160 = select(_e138.member[1], _e133.member[1], (_e133.member[1] < _e138.member[1]));
                        let _e166 = select(_e138.member[2], _e133.member[2], (_e133.member[2] < _e138.member[2]));
                        let _e172 = select(_e138.member_1[0], _e133.member_1[0], (_e133.member_1[0] > _e138.member_1[0]));
                        let _e178 = select(_e138.member_1[1], _e133.member_1[1], (_e133.member_1[1] > _e138.member_1[1]));
                        let _e184 = select(_e138.member_1[2], _e133.member_1[2], (_e133.member_1[2] > _e138.member_1[2]));
                        let _e190 = select(_e148.member[0], _e143.member[0], (_e143.member[0] < _e148.member[0]));
                        let _e196 = select(_e148.member[1], _e143.member[1], (_e143.member[1] < _e148.member[1]));
                        let _e202 = select(_e148.member[2], _e143.member[2], (_e143.member[2] < _e148.member[2]));
                        let _e208 = select(_e148.member_1[0], _e143.member_1[0], (_e143.member_1[0] > _e148.member_1[0]));
                        let _e214 = select(_e148.member_1[1], _e143.member_1[1], (_e143.member_1[1] > _e148.member_1[1]));
                        let _e220 = select(_e148.member_1[2], _e143.member_1[2], (_e143.member_1[2] > _e148.member_1[2]));
                        let _e222 = select(_e190, _e154, (_e154 < _e190));
                        let _e224 = select(_e196, _e160, (_e160 < _e196));
                        let _e226 = select(_e202, _e166, (_e166 < _e202));
                        let _e228 = select(_e208, _e172, (_e172 > _e208));
                        let _e230 = select(_e214, _e178, (_e178 > _e214));
                        let _e232 = select(_e220, _e184, (_e184 > _e220));
                        phi_214_ = type_19(array<f32, 3>(select(_e222, _e102.member[0], (_e102.member[0] < _e222)), select(_e224, _e102.member[1], (_e102.member[1] < _e224)), select(_e226, _e102.member[2], (_e102.member[2] < _e226))), array<f32, 3>(select(_e228, _e102.member_1[0], (_e102.member_1[0] > _e228)), select(_e230, _e102.member_1[1], (_e102.member_1[1] > _e230)), select(_e232, _e102.member_1[2], (_e102.member_1[2] > _e232))));
                    } else {
                        phi_214_ = type_19();
                    }
                    let _e261 = phi_214_;
                    continue;
                    continuing {
                        phi_210_ = type_9(select(_e100.member, (_e100.member + 1u), _e105), select(_e100.member_1, _e100.member_1, _e105));
                        phi_213_ = _e261;
                        break if !(_e118);
                    }
                }
                let _e263 = (_e58 - _e90);
                let _e264 = (_e263 / 4u);
                phi_505_ = type_9(0u, select(_e264, (_e264 + 1u), ((_e263 % 4u) > 0u)));
                let _e491 = local_2;
                phi_508_ = _e491;
                loop {
                    let _e271 = phi_505_;
                    let _e273 = phi_508_;
                    local_3 = _e273;
                    let _e276 = (_e271.member < _e271.member_1);
                    let _e289 = (bitcast<i32>(select(0u, 1u, _e276)) != 0i);
                    if _e289 {
                        let _e295 = params.member.member_2.member[_e74][_e40];
                        let _e296 = (_e295 + (_e90 + (4u * select(type_9().member_1, _e271.member, _e276))));
                        let _e300 = params.member.member_2.member[_e74][_e40];
                        let _e302 = ((_e300 + _e58) - 1u);
                        let _e304 = block_nodes.member[_e296];
                        let _e305 = (_e296 + 1u);
                        let _e309 = block_nodes.member[select(_e305, _e302, (_e302 < _e305))];
                        let _e310 = (_e296 + 2u);
                        let _e314 = block_nodes.member[select(_e310, _e302, (_e302 < _e310))];
                        let _e315 = (_e296 + 3u);
                        let _e319 = block_nodes.member[select(_e315, _e302, (_e302 < _e315))];
                        let _e325 = select(_e309.member[0], _e304.member[0], (_e304.member[0] < _e309.member[0]));
                        let _e331 = select(_e309.member[1], _e304.member[1], (_e304.member[1] < _e309.member[1]));
                        let _e337 = select(_e309.member[2], _e304.member[2], (_e304.member[2] < _e309.member[2]));
                        let _e343 = select(_e309.member_1[0], _e304.member_1[0], (_e304.member_1[0] > _e309.member_1[0]));
                        let _e349 = select(_e309.member_1[1], _e304.member_1[1], (_e304.member_1[1] > _e309.member_1[1]));
                        let _e355 = select(_e309.member_1[2], _e304.member_1[2], (_e304.member_1[2] > _e309.member_1[2]));
                        let _e361 = select(_e319.member[0], _e314.member[0], (_e314.member[0] < _e319.member[0]));
                        let _e367 = select(_e319.member[1], _e314.member[1], (_e314.member[1] < _e319.member[1]));
                        let _e373 = select(_e319.member[2], _e314.member[2], (_e314.member[2] < _e319.member[2]));
                        let _e379 = select(_e319.member_1[0], _e314.member_1[0], (_e314.member_1[0] > _e319.member_1[0]));
                        let _e385 = select(_e319.member_1[1], _e314.member_1[1], (_e314.member_1[1] > _e319.member_1[1]));
                        let _e391 = select(_e319.member_1[2], _e314.member_1[2], (_e314.member_1[2] > _e319.member_1[2]));
                        let _e393 = select(_e361, _e325, (_e325 < _e361));
                        let _e395 = select(_e367, _e331, (_e331 < _e367));
                        let _e397 = select(_e373, _e337, (_e337 < _e373));
                        let _e399 = select(_e379, _e343, (_e343 > _e379));
                        let _e401 = select(_e385, _e349, (_e349 > _e385));
                        let _e403 = select(_e391, _e355, (_e355 > _e391));
                        phi_509_ = type_19(array<f32, 3>(select(_e393, _e273.member[0], (_e273.member[0] < _e393)), select(_e395, _e273.member[1], (_e273.member[1] < _e395)), select(_e397, _e273.member[2], (_e273.member[2] < _e397))), array<f32, 3>(select(_e399, _e273.member_1[0], (_e273.member_1[0] > _e399)), select(_e401, _e273.member_1[1], (_e273.member_1[1] > _e401)), select(_e403, _e273.member_1[2], (_e273.member_1[2] > _e403))));
                    } else {
                        phi_509_ = type_19();
                    }
                    let _e432 = phi_509_;
                    continue;
                    continuing {
                        phi_505_ = type_9(select(_e271.member, (_e271.member + 1u), _e276), select(_e271.member_1, _e271.member_1, _e276));
                        phi_508_ = _e432;
                        break if !(_e289);
                    }
                }
                if _e89 {
                    phi_785_ = (_e81 / 32u);
                } else {
                    phi_785_ = 0u;
                }
                let _e436 = phi_785_;
                if _e89 {
                    phi_790_ = (_e83 / 32u);
                } else {
                    phi_790_ = 0u;
                }
                let _e439 = phi_790_;
                let _e497 = local_3;
                phi_130_ = _e497;
                phi_132_ = _e439;
                phi_134_ = _e436;
            } else {
                phi_130_ = type_19();
                phi_132_ = u32();
                phi_134_ = u32();
            }
            let _e441 = phi_130_;
            let _e443 = phi_132_;
            let _e445 = phi_134_;
            continue;
            continuing {
                phi_126_ = type_9(select(_e54.member, (_e54.member + 1u), _e63), select(_e54.member_1, _e54.member_1, _e63));
                phi_129_ = _e441;
                phi_131_ = _e443;
                phi_133_ = _e445;
                break if !(_e76);
            }
        }
        let _e448 = local;
        let _e452 = local_1;
        nodes.member[_e37] = type_24(_e448.member, _e48.member, _e452.member_1, _e48.member_1);
    }
    if (_e37 < _e44) {
        let _e462 = params.member.member_2.member[0u][_e40];
        let _e465 = block_nodes.member[(_e462 + _e37)];
        let _e469 = params.member.member.member_2[_e40];
        let _e472 = order.member[(_e469 + _e37)];
        nodes.member[((_e44 - 1u) + _e37)] = type_24(_e465.member, (_e472 - _e469), _e465.member_1, 4294967295u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn branch_boxes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
