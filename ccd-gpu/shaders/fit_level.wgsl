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

struct type_11 {
    member: i32,
    member_1: i32,
}

struct type_12 {
    member: u32,
    member_1: i32,
}

struct type_14 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_7,
    member_1: type_8,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_16;
var<workgroup> shared_: array<type_22, 256>;
@group(0) @binding(1) 
var<storage, read_write> nodes: type_20;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 4>;
    var phi_120_: u32;
    var phi_121_: u32;
    var phi_147_: type_22;
    var phi_162_: type_11;
    var phi_165_: type_22;
    var phi_167_: u32;
    var phi_188_: bool;
    var phi_194_: type_12;
    var phi_163_: type_11;
    var phi_208_: type_12;
    var phi_240_: f32;
    var phi_247_: f32;
    var phi_254_: f32;
    var phi_262_: f32;
    var phi_269_: f32;
    var phi_276_: f32;
    var phi_291_: type_22;
    var phi_166_: type_22;
    var phi_168_: u32;
    var local_1: type_22;
    var local_2: type_22;
    var local_3: type_22;
    var local_4: type_22;
    var local_5: type_22;
    var local_6: type_22;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e35 = params.member.member_2.member_2;
    let _e39 = params.member.member_2.member[_e35];
    local = array<u32, 4>(_e39[0], _e39[1], _e39[2], _e39[3]);
    let _e46 = local[0u];
    let _e49 = ((_e46 + (((_e23.y * _e24.x) + _e23.x) * 256u)) + _e25);
    let _e51 = local[2u];
    if (_e49 >= _e51) {
        phi_121_ = 2u;
    } else {
        let _e54 = local[1u];
        if (_e49 >= _e54) {
            phi_120_ = 1u;
        } else {
            phi_120_ = 0u;
        }
        let _e57 = phi_120_;
        phi_121_ = _e57;
    }
    let _e59 = phi_121_;
    let _e61 = local[3u];
    let _e62 = (_e49 < _e61);
    if _e62 {
        let _e64 = nodes.member[_e49];
        phi_147_ = type_22(array<f32, 3>(_e64.member.x, _e64.member.y, _e64.member_1.x), array<f32, 3>(_e64.member_1.y, _e64.member_2.x, _e64.member_2.y));
    } else {
        phi_147_ = type_22(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e81 = phi_147_;
    shared_[_e25] = type_22(array<f32, 3>(_e81.member[0], _e81.member[1], _e81.member[2]), array<f32, 3>(_e81.member_1[0], _e81.member_1[1], _e81.member_1[2]));
    phi_162_ = type_11(0i, 5i);
    phi_165_ = _e81;
    phi_167_ = 16u;
    loop {
        let _e95 = phi_162_;
        let _e97 = phi_165_;
        let _e99 = phi_167_;
        local_1 = _e97;
        local_2 = _e97;
        local_3 = _e97;
        local_4 = _e97;
        local_5 = _e97;
        local_6 = _e97;
        if (_e95.member < _e95.member_1) {
            let _e106 = (_e95.member + 1i);
            if ((false == (_e106 > _e95.member)) != false) {
                phi_188_ = true;
            } else {
                phi_188_ = false;
            }
            let _e111 = phi_188_;
            if _e111 {
                phi_194_ = type_12(0u, type_12().member_1);
            } else {
                phi_194_ = type_12(1u, _e106);
            }
            let _e116 = phi_194_;
            phi_163_ = type_11(_e116.member_1, _e95.member_1);
            phi_208_ = type_12(1u, _e95.member);
        } else {
            phi_163_ = _e95;
            phi_208_ = type_12(0u, type_12().member_1);
        }
        let _e122 = phi_163_;
        let _e124 = phi_208_;
        let _e127 = (bitcast<i32>(_e124.member) != 0i);
        if _e127 {
            workgroupBarrier();
            if ((_e25 % 32u) < _e99) {
                let _e132 = shared_[(_e25 + _e99)];
                if (_e97.member[0] < _e132.member[0]) {
                    phi_240_ = _e97.member[0];
                } else {
                    phi_240_ = _e132.member[0];
                }
                let _e145 = phi_240_;
                if (_e97.member[1] < _e132.member[1]) {
                    phi_247_ = _e97.member[1];
                } else {
                    phi_247_ = _e132.member[1];
                }
                let _e150 = phi_247_;
                if (_e97.member[2] < _e132.member[2]) {
                    phi_254_ = _e97.member[2];
                } else {
                    phi_254_ = _e132.member[2];
                }
                let _e155 = phi_254_;
                if (_e97.member_1[0] > _e132.member_1[0]) {
                    phi_262_ = _e97.member_1[0];
                } else {
                    phi_262_ = _e132.member_1[0];
                }
                let _e161 = phi_262_;
                if (_e97.member_1[1] > _e132.member_1[1]) {
                    phi_269_ = _e97.member_1[1];
                } else {
                    phi_269_ = _e132.member_1[1];
                }
                let _e166 = phi_269_;
                if (_e97.member_1[2] > _e132.member_1[2]) {
                    phi_276_ = _e97.member_1[2];
                } else {
                    phi_276_ = _e132.member_1[2];
                }
                let _e171 = phi_276_;
                shared_[_e25] = type_22(array<f32, 3>(_e145, _e150, _e155), array<f32, 3>(_e161, _e166, _e171));
                phi_291_ = type_22(array<f32, 3>(_e145, _e150, _e155), array<f32, 3>(_e161, _e166, _e171));
            } else {
                phi_291_ = _e97;
            }
            let _e179 = phi_291_;
            phi_166_ = _e179;
            phi_168_ = (_e99 / 2u);
        } else {
            phi_166_ = type_22();
            phi_168_ = u32();
        }
        let _e182 = phi_166_;
        let _e184 = phi_168_;
        continue;
        continuing {
            phi_162_ = _e122;
            phi_165_ = _e182;
            phi_167_ = _e184;
            break if !(_e127);
        }
    }
    if _e62 {
        if ((_e25 % 32u) == 0u) {
            let _e191 = params.member.member_2.member_2;
            let _e194 = local[_e59];
            let _e200 = params.member.member_2.member[(_e191 + 1u)][_e59];
            let _e203 = local_1;
            let _e207 = local_2;
            let _e211 = local_3;
            let _e215 = local_4;
            let _e219 = local_5;
            let _e223 = local_6;
            nodes.member[(_e200 + ((_e49 - _e194) / 32u))] = type_18(vec2<f32>(_e203.member[0], _e207.member[1]), vec2<f32>(_e211.member[2], _e215.member_1[0]), vec2<f32>(_e219.member_1[1], _e223.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
