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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: array<type_18>,
}

@group(0) @binding(0) 
var<storage> params: type_16;
var<workgroup> shared_: array<type_18, 256>;
@group(0) @binding(1) 
var<storage, read_write> nodes: type_20;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 4>;
    var phi_117_: u32;
    var phi_118_: u32;
    var phi_135_: type_18;
    var phi_150_: type_11;
    var phi_153_: type_18;
    var phi_155_: u32;
    var phi_176_: bool;
    var phi_182_: type_12;
    var phi_151_: type_11;
    var phi_196_: type_12;
    var phi_228_: f32;
    var phi_235_: f32;
    var phi_242_: f32;
    var phi_250_: f32;
    var phi_257_: f32;
    var phi_264_: f32;
    var phi_279_: type_18;
    var phi_154_: type_18;
    var phi_156_: u32;
    var local_1: type_18;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e30 = params.member.member_2.member_2;
    let _e34 = params.member.member_2.member[_e30];
    local = array<u32, 4>(_e34[0], _e34[1], _e34[2], _e34[3]);
    let _e41 = local[0u];
    let _e49 = ((_e41 + (((_e23.y * _e24.x) + _e23.x) * 256u)) + _e25);
    let _e51 = local[2u];
    if (_e49 >= _e51) {
        phi_118_ = 2u;
    } else {
        let _e54 = local[1u];
        if (_e49 >= _e54) {
            phi_117_ = 1u;
        } else {
            phi_117_ = 0u;
        }
        let _e57 = phi_117_;
        phi_118_ = _e57;
    }
    let _e59 = phi_118_;
    let _e61 = local[3u];
    let _e62 = (_e49 < _e61);
    if _e62 {
        let _e64 = nodes.member[_e49];
        phi_135_ = _e64;
    } else {
        phi_135_ = type_18(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e66 = phi_135_;
    shared_[_e25] = type_18(array<f32, 3>(_e66.member[0], _e66.member[1], _e66.member[2]), array<f32, 3>(_e66.member_1[0], _e66.member_1[1], _e66.member_1[2]));
    phi_150_ = type_11(0i, 5i);
    phi_153_ = _e66;
    phi_155_ = 16u;
    loop {
        let _e80 = phi_150_;
        let _e82 = phi_153_;
        let _e84 = phi_155_;
        local_1 = _e82;
        if (_e80.member < _e80.member_1) {
            let _e91 = (_e80.member + 1i);
            if ((false == (_e91 > _e80.member)) != false) {
                phi_176_ = true;
            } else {
                phi_176_ = false;
            }
            let _e96 = phi_176_;
            if _e96 {
                phi_182_ = type_12(0u, type_12().member_1);
            } else {
                phi_182_ = type_12(1u, _e91);
            }
            let _e101 = phi_182_;
            phi_151_ = type_11(_e101.member_1, _e80.member_1);
            phi_196_ = type_12(1u, _e80.member);
        } else {
            phi_151_ = _e80;
            phi_196_ = type_12(0u, type_12().member_1);
        }
        let _e107 = phi_151_;
        let _e109 = phi_196_;
        let _e112 = (bitcast<i32>(_e109.member) != 0i);
        if _e112 {
            workgroupBarrier();
            if ((_e25 % 32u) < _e84) {
                let _e117 = shared_[(_e25 + _e84)];
                if (_e82.member[0] < _e117.member[0]) {
                    phi_228_ = _e82.member[0];
                } else {
                    phi_228_ = _e117.member[0];
                }
                let _e130 = phi_228_;
                if (_e82.member[1] < _e117.member[1]) {
                    phi_235_ = _e82.member[1];
                } else {
                    phi_235_ = _e117.member[1];
                }
                let _e135 = phi_235_;
                if (_e82.member[2] < _e117.member[2]) {
                    phi_242_ = _e82.member[2];
                } else {
                    phi_242_ = _e117.member[2];
                }
                let _e140 = phi_242_;
                if (_e82.member_1[0] > _e117.member_1[0]) {
                    phi_250_ = _e82.member_1[0];
                } else {
                    phi_250_ = _e117.member_1[0];
                }
                let _e146 = phi_250_;
                if (_e82.member_1[1] > _e117.member_1[1]) {
                    phi_257_ = _e82.member_1[1];
                } else {
                    phi_257_ = _e117.member_1[1];
                }
                let _e151 = phi_257_;
                if (_e82.member_1[2] > _e117.member_1[2]) {
                    phi_264_ = _e82.member_1[2];
                } else {
                    phi_264_ = _e117.member_1[2];
                }
                let _e156 = phi_264_;
                shared_[_e25] = type_18(array<f32, 3>(_e130, _e135, _e140), array<f32, 3>(_e146, _e151, _e156));
                phi_279_ = type_18(array<f32, 3>(_e130, _e135, _e140), array<f32, 3>(_e146, _e151, _e156));
            } else {
                phi_279_ = _e82;
            }
            let _e164 = phi_279_;
            phi_154_ = _e164;
            phi_156_ = (_e84 / 2u);
        } else {
            phi_154_ = type_18();
            phi_156_ = u32();
        }
        let _e167 = phi_154_;
        let _e169 = phi_156_;
        continue;
        continuing {
            phi_150_ = _e107;
            phi_153_ = _e167;
            phi_155_ = _e169;
            break if !(_e112);
        }
    }
    if _e62 {
        if ((_e25 % 32u) == 0u) {
            let _e176 = params.member.member_2.member_2;
            let _e179 = local[_e59];
            let _e185 = params.member.member_2.member[(_e176 + 1u)][_e59];
            let _e189 = local_1;
            nodes.member[(_e185 + ((_e49 - _e179) / 32u))] = _e189;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
