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

struct type_14 {
    member: array<vec4<u32>>,
}

struct type_15 {
    member: u32,
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

struct type_18 {
    member: f32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> items: type_14;
@group(0) @binding(2) 
var<storage, read_write> found: type_10;
var<workgroup> least: array<atomic<u32>, 2>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_160_: type_18;
    var phi_161_: bool;
    var phi_170_: type_18;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e17 = id_2;
    let _e18 = n_2;
    let _e19 = lane_2;
    let _e27 = ((_e17.y * _e18.x) + _e17.x);
    let _e31 = found.member[0u];
    if (_e19 == 0u) {
        atomicStore((&least[0u]), 2137108966u);
        atomicStore((&least[1u]), 4294967295u);
    }
    workgroupBarrier();
    let _e35 = (_e31 + 1u);
    let _e38 = ((_e31 + 1u) + ((_e27 * 256u) + _e19));
    let _e41 = params.member.member_1.member;
    if (_e38 < _e41) {
        let _e44 = items.member[_e31];
        let _e52 = items.member[_e38];
        let _e59 = (bitcast<f32>(_e44.x) - bitcast<f32>(_e52.x));
        let _e60 = (bitcast<f32>(_e44.y) - bitcast<f32>(_e52.y));
        let _e61 = (bitcast<f32>(_e44.z) - bitcast<f32>(_e52.z));
        let _e66 = (((_e59 * _e59) + (_e60 * _e60)) + (_e61 * _e61));
        if (_e66 < 300000000000000000000000000000000000000f) {
            phi_160_ = type_18();
            phi_161_ = true;
        } else {
            let _e71 = select(true, select(true, false, (_e38 < _e35)), (_e66 == 300000000000000000000000000000000000000f));
            phi_160_ = type_18(select(type_18().member, 300000000000000000000000000000000000000f, _e71), select(type_18().member_1, _e35, _e71));
            phi_161_ = select(true, false, _e71);
        }
        let _e79 = phi_160_;
        let _e81 = phi_161_;
        phi_170_ = type_18(select(_e79.member, _e66, _e81), select(_e79.member_1, _e38, _e81));
    } else {
        phi_170_ = type_18(300000000000000000000000000000000000000f, _e35);
    }
    let _e88 = phi_170_;
    let _e92 = atomicMin((&least[0u]), bitcast<u32>(_e88.member));
    workgroupBarrier();
    let _e96 = atomicLoad((&least[0u]));
    if (bitcast<u32>(_e88.member) == _e96) {
        let _e100 = atomicMin((&least[1u]), _e88.member_1);
    }
    workgroupBarrier();
    if (_e19 == 0u) {
        let _e105 = atomicLoad((&least[0u]));
        found.member[(1u + (2u * _e27))] = _e105;
        let _e110 = atomicLoad((&least[1u]));
        found.member[((2u * _e27) + 2u)] = _e110;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_search(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
