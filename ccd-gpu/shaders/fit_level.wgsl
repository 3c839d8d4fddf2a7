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
    var phi_125_: u32;
    var phi_151_: type_22;
    var phi_171_: type_11;
    var phi_174_: type_22;
    var phi_176_: u32;
    var phi_172_: type_11;
    var phi_217_: type_12;
    var phi_369_: type_22;
    var phi_370_: type_22;
    var phi_416_: type_22;
    var phi_429_: type_22;
    var phi_175_: type_22;
    var phi_177_: u32;
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
    let _e26 = id_2;
    let _e27 = n_2;
    let _e28 = lane_2;
    let _e38 = params.member.member_2.member_2;
    let _e42 = params.member.member_2.member[_e38];
    local = array<u32, 4>(_e42[0], _e42[1], _e42[2], _e42[3]);
    let _e49 = local[0u];
    let _e52 = ((_e49 + (((_e26.y * _e27.x) + _e26.x) * 256u)) + _e28);
    let _e54 = local[2u];
    if (_e52 >= _e54) {
        phi_125_ = 2u;
    } else {
        let _e57 = local[1u];
        phi_125_ = select(0u, 1u, (_e52 >= _e57));
    }
    let _e61 = phi_125_;
    let _e63 = local[3u];
    let _e64 = (_e52 < _e63);
    if _e64 {
        let _e66 = nodes.member[_e52];
        phi_151_ = type_22(array<f32, 3>(_e66.member.x, _e66.member.y, _e66.member_1.x), array<f32, 3>(_e66.member_1.y, _e66.member_2.x, _e66.member_2.y));
    } else {
        phi_151_ = type_22(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e83 = phi_151_;
    let _e86 = params.member.member.member_1;
    shared_[_e28] = type_22(array<f32, 3>(_e83.member[0], _e83.member[1], _e83.member[2]), array<f32, 3>(_e83.member_1[0], _e83.member_1[1], _e83.member_1[2]));
    phi_171_ = type_11(0i, 5i);
    phi_174_ = _e83;
    phi_176_ = 16u;
    loop {
        let _e102 = phi_171_;
        let _e104 = phi_174_;
        let _e106 = phi_176_;
        local_1 = _e104;
        local_2 = _e104;
        local_3 = _e104;
        local_4 = _e104;
        local_5 = _e104;
        local_6 = _e104;
        if (_e102.member < _e102.member_1) {
            let _e113 = (_e102.member + 1i);
            phi_172_ = type_11(select(_e113, type_12().member_1, select(false, true, ((false == (_e113 > _e102.member)) != false))), _e102.member_1);
            phi_217_ = type_12(1u, _e102.member);
        } else {
            phi_172_ = _e102;
            phi_217_ = type_12(0u, type_12().member_1);
        }
        let _e124 = phi_172_;
        let _e126 = phi_217_;
        let _e129 = (bitcast<i32>(_e126.member) != 0i);
        if _e129 {
            workgroupBarrier();
            if ((_e28 % 32u) < _e106) {
                let _e134 = shared_[(_e28 + _e106)];
                if ((_e86 & 256u) != 0u) {
                    let _e173 = select(_e134.member[0], _e104.member[0], (_e104.member[0] < _e134.member[0]));
                    let _e186 = select(_e134.member_1[0], _e104.member_1[0], (_e104.member_1[0] > _e134.member_1[0]));
                    let _e196 = type_22(array<f32, 3>(_e173, select(_e134.member[1], _e104.member[1], (_e104.member[1] < _e134.member[1])), select(_e134.member[2], _e104.member[2], (_e104.member[2] < _e134.member[2]))), array<f32, 3>(_e186, select(_e134.member_1[1], _e104.member_1[1], (_e104.member_1[1] > _e134.member_1[1])), select(_e134.member_1[2], _e104.member_1[2], (_e104.member_1[2] > _e134.member_1[2]))));
                    if (_e173 <= _e186) {
                        if (((bitcast<u32>(_e186) & 1u) == 1u) != select(false, select(!((_e134.member[0] <= _e134.member_1[0])), true, ((bitcast<u32>(_e134.member_1[0]) & 1u) == 1u)), select(!((_e104.member[0] <= _e104.member_1[0])), true, ((bitcast<u32>(_e104.member_1[0]) & 1u) == 1u)))) {
                            let _e221 = bitcast<u32>(_e186);
                            let _e224 = ((_e221 >> bitcast<u32>(31i)) == 1u);
                            let _e225 = (_e221 & 2147483647u);
                            let _e226 = (_e225 < 8388608u);
                            let _e229 = select(true, select(true, false, (_e225 == 8388608u)), _e224);
                            phi_369_ = type_22(_e196.member, array<f32, 3>(bitcast<f32>(select(select(select(u32(), select((_e221 + 1u), (_e221 - 1u), _e224), _e229), u32(), _e226), (8388608u | ((_e221 & 1u) ^ 1u)), select(select(true, false, _e229), true, _e226))), _e196.member_1[1], _e196.member_1[2]));
                        } else {
                            phi_369_ = _e196;
                        }
                        let _e249 = phi_369_;
                        phi_370_ = _e249;
                    } else {
                        phi_370_ = _e196;
                    }
                    let _e251 = phi_370_;
                    phi_416_ = _e251;
                } else {
                    phi_416_ = type_22(array<f32, 3>(select(_e134.member[0], _e104.member[0], (_e104.member[0] < _e134.member[0])), select(_e134.member[1], _e104.member[1], (_e104.member[1] < _e134.member[1])), select(_e134.member[2], _e104.member[2], (_e104.member[2] < _e134.member[2]))), array<f32, 3>(select(_e134.member_1[0], _e104.member_1[0], (_e104.member_1[0] > _e134.member_1[0])), select(_e134.member_1[1], _e104.member_1[1], (_e104.member_1[1] > _e134.member_1[1])), select(_e134.member_1[2], _e104.member_1[2], (_e104.member_1[2] > _e134.member_1[2]))));
                }
                let _e253 = phi_416_;
                shared_[_e28] = type_22(array<f32, 3>(_e253.member[0], _e253.member[1], _e253.member[2]), array<f32, 3>(_e253.member_1[0], _e253.member_1[1], _e253.member_1[2]));
                phi_429_ = _e253;
            } else {
                phi_429_ = _e104;
            }
            let _e267 = phi_429_;
            phi_175_ = _e267;
            phi_177_ = (_e106 / 2u);
        } else {
            phi_175_ = type_22();
            phi_177_ = u32();
        }
        let _e270 = phi_175_;
        let _e272 = phi_177_;
        continue;
        continuing {
            phi_171_ = _e124;
            phi_174_ = _e270;
            phi_176_ = _e272;
            break if !(_e129);
        }
    }
    if _e64 {
        if ((_e28 % 32u) == 0u) {
            let _e279 = params.member.member_2.member_2;
            let _e282 = local[_e61];
            let _e288 = params.member.member_2.member[(_e279 + 1u)][_e61];
            let _e291 = local_1;
            let _e295 = local_2;
            let _e299 = local_3;
            let _e303 = local_4;
            let _e307 = local_5;
            let _e311 = local_6;
            nodes.member[(_e288 + ((_e52 - _e282) / 32u))] = type_18(vec2<f32>(_e291.member[0], _e295.member[1]), vec2<f32>(_e299.member[2], _e303.member_1[0]), vec2<f32>(_e307.member_1[1], _e311.member_1[2]));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn fit_level(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
