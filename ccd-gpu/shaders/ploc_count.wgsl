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

@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(1) 
var<storage> neighbours: type_10;
@group(0) @binding(2) 
var<storage, read_write> counts: type_17;
var<workgroup> left: array<atomic<u32>, 2>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e14 = id_2;
    let _e15 = n_2;
    let _e16 = lane_2;
    let _e24 = ((_e14.y * _e15.x) + _e14.x);
    let _e27 = params.member.member_1.member_1;
    let _e29 = atomicLoad((&counts.member[_e27]));
    let _e31 = select(0u, _e29, (_e29 > 256u));
    let _e33 = ((_e24 * 256u) + _e16);
    if (_e16 == 0u) {
        atomicStore((&left[0u]), 0u);
    }
    workgroupBarrier();
    if (_e33 < _e31) {
        let _e38 = neighbours.member[_e33];
        let _e40 = neighbours.member[_e38];
        let _e41 = (_e33 == _e38);
        let _e42 = (_e40 != _e33);
        if !((select(select(select(select(2u, 1u, (_e33 < _e38)), u32(), _e42), u32(), _e41), 0u, select(_e42, true, _e41)) == 2u)) {
            let _e52 = atomicAdd((&left[0u]), 1u);
        }
    }
    workgroupBarrier();
    if (_e16 == 0u) {
        if (_e33 < _e31) {
            let _e57 = params.member.member_2.member;
            let _e61 = params.member.member.member[_e57];
            let _e62 = (_e61 / 256u);
            let _e66 = select(_e62, (_e62 + 1u), ((_e61 % 256u) > 0u));
            let _e67 = (_e66 / 256u);
            let _e75 = atomicLoad((&left[0u]));
            atomicStore((&counts.member[(192u + (select(_e67, (_e67 + 1u), ((_e66 % 256u) > 0u)) + _e24))]), _e75);
            let _e80 = atomicLoad((&left[0u]));
            let _e82 = atomicAdd((&counts.member[(192u + (_e24 / 256u))]), _e80);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn ploc_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
