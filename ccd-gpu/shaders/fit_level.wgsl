struct type_8 {
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

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
}

struct type_17 {
    member: i32,
    member_1: i32,
}

struct type_18 {
    member: u32,
    member_1: i32,
}

@group(0) @binding(0) 
var<storage> params: type_9;
var<workgroup> shared_: array<type_11, 256>;
@group(0) @binding(1) 
var<storage, read_write> nodes: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 4>;
    var phi_115_: u32;
    var phi_116_: u32;
    var phi_133_: type_11;
    var phi_148_: type_17;
    var phi_151_: type_11;
    var phi_153_: u32;
    var phi_174_: bool;
    var phi_180_: type_18;
    var phi_149_: type_17;
    var phi_194_: type_18;
    var phi_226_: f32;
    var phi_233_: f32;
    var phi_240_: f32;
    var phi_248_: f32;
    var phi_255_: f32;
    var phi_262_: f32;
    var phi_277_: type_11;
    var phi_152_: type_11;
    var phi_154_: u32;
    var local_1: type_11;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e29 = params.member.member_9;
    let _e32 = params.member.member_20[_e29];
    local = array<u32, 4>(_e32[0], _e32[1], _e32[2], _e32[3]);
    let _e39 = local[0u];
    let _e47 = ((_e39 + (((_e23.y * _e24.x) + _e23.x) * 256u)) + _e25);
    let _e49 = local[2u];
    if (_e47 >= _e49) {
        phi_116_ = 2u;
    } else {
        let _e52 = local[1u];
        if (_e47 >= _e52) {
            phi_115_ = 1u;
        } else {
            phi_115_ = 0u;
        }
        let _e55 = phi_115_;
        phi_116_ = _e55;
    }
    let _e57 = phi_116_;
    let _e59 = local[3u];
    let _e60 = (_e47 < _e59);
    if _e60 {
        let _e62 = nodes.member[_e47];
        phi_133_ = _e62;
    } else {
        phi_133_ = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e64 = phi_133_;
    shared_[_e25] = type_11(array<f32, 3>(_e64.member[0], _e64.member[1], _e64.member[2]), array<f32, 3>(_e64.member_1[0], _e64.member_1[1], _e64.member_1[2]));
    phi_148_ = type_17(0i, 5i);
    phi_151_ = _e64;
    phi_153_ = 16u;
    loop {
        let _e78 = phi_148_;
        let _e80 = phi_151_;
        let _e82 = phi_153_;
        local_1 = _e80;
        if (_e78.member < _e78.member_1) {
            let _e89 = (_e78.member + 1i);
            if ((false == (_e89 > _e78.member)) != false) {
                phi_174_ = true;
            } else {
                phi_174_ = false;
            }
            let _e94 = phi_174_;
            if _e94 {
                phi_180_ = type_18(0u, type_18().member_1);
            } else {
                phi_180_ = type_18(1u, _e89);
            }
            let _e99 = phi_180_;
            phi_149_ = type_17(_e99.member_1, _e78.member_1);
            phi_194_ = type_18(1u, _e78.member);
        } else {
            phi_149_ = _e78;
            phi_194_ = type_18(0u, type_18().member_1);
        }
        let _e105 = phi_149_;
        let _e107 = phi_194_;
        let _e110 = (bitcast<i32>(_e107.member) != 0i);
        if _e110 {
            workgroupBarrier();
            if ((_e25 % 32u) < _e82) {
                let _e115 = shared_[(_e25 + _e82)];
                if (_e80.member[0] < _e115.member[0]) {
                    phi_226_ = _e80.member[0];
                } else {
                    phi_226_ = _e115.member[0];
                }
                let _e128 = phi_226_;
                if (_e80.member[1] < _e115.member[1]) {
                    phi_233_ = _e80.member[1];
                } else {
                    phi_233_ = _e115.member[1];
                }
                let _e133 = phi_233_;
                if (_e80.member[2] < _e115.member[2]) {
                    phi_240_ = _e80.member[2];
                } else {
                    phi_240_ = _e115.member[2];
                }
                let _e138 = phi_240_;
                if (_e80.member_1[0] > _e115.member_1[0]) {
                    phi_248_ = _e80.member_1[0];
                } else {
                    phi_248_ = _e115.member_1[0];
                }
                let _e144 = phi_248_;
                if (_e80.member_1[1] > _e115.member_1[1]) {
                    phi_255_ = _e80.member_1[1];
                } else {
                    phi_255_ = _e115.member_1[1];
                }
                let _e149 = phi_255_;
                if (_e80.member_1[2] > _e115.member_1[2]) {
                    phi_262_ = _e80.member_1[2];
                } else {
                    phi_262_ = _e115.member_1[2];
                }
                let _e154 = phi_262_;
                shared_[_e25] = type_11(array<f32, 3>(_e128, _e133, _e138), array<f32, 3>(_e144, _e149, _e154));
                phi_277_ = type_11(array<f32, 3>(_e128, _e133, _e138), array<f32, 3>(_e144, _e149, _e154));
            } else {
                phi_277_ = _e80;
            }
            let _e162 = phi_277_;
            phi_152_ = _e162;
            phi_154_ = (_e82 / 2u);
        } else {
            phi_152_ = type_11();
            phi_154_ = u32();
        }
        let _e165 = phi_152_;
        let _e167 = phi_154_;
        continue;
        continuing {
            phi_148_ = _e105;
            phi_151_ = _e165;
            phi_153_ = _e167;
            break if !(_e110);
        }
    }
    if _e60 {
        if ((_e25 % 32u) == 0u) {
            let _e172 = params.member.member_9;
            let _e175 = local[_e57];
            let _e181 = params.member.member_20[(_e172 + 1u)][_e57];
            let _e185 = local_1;
            nodes.member[(_e181 + ((_e47 - _e175) / 32u))] = _e185;
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
