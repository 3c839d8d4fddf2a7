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

struct type_12 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_13 {
    member: type_7,
    member_1: type_8,
    member_2: type_12,
}

struct type_14 {
    member: type_13,
}

struct type_17 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> keys: type_10;
@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(2) 
var<storage, read_write> levels: type_10;
@group(0) @binding(3) 
var<storage, read_write> present: type_17;
var<workgroup> shared_: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_139_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e15 = id_2;
    let _e16 = n_2;
    let _e17 = lane_2;
    let _e28 = ((((_e15.y * _e16.x) + _e15.x) * 256u) + _e17);
    if (_e17 < 3u) {
        atomicStore((&shared_[_e17]), 0u);
    }
    workgroupBarrier();
    let _e33 = params.member.member_2.member;
    let _e37 = params.member.member.member[_e33];
    if (_e28 < (_e37 - 1u)) {
        let _e42 = params.member.member_2.member;
        let _e46 = params.member.member.member_2[_e42];
        let _e49 = keys.member[(_e46 + _e28)];
        let _e53 = keys.member[((_e46 + _e28) + 1u)];
        let _e54 = (_e49 ^ _e53);
        let _e59 = select((bitcast<u32>(31i) - firstLeadingBit(_e54)), 32u, (_e54 == 0u));
        if (_e59 < 32u) {
            phi_139_ = _e59;
        } else {
            let _e62 = (_e28 ^ (_e28 + 1u));
            phi_139_ = (32u + select((bitcast<u32>(31i) - firstLeadingBit(_e62)), 32u, (_e62 == 0u)));
        }
        let _e70 = phi_139_;
        levels.member[_e28] = _e70;
        let _e78 = atomicOr((&shared_[(_e70 / 32u)]), (1u << bitcast<u32>(((_e70 % 32u) & 31u))));
    }
    workgroupBarrier();
    if (_e17 < 3u) {
        let _e81 = atomicLoad((&shared_[_e17]));
        let _e83 = atomicOr((&present.member[_e17]), _e81);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn split_levels(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
