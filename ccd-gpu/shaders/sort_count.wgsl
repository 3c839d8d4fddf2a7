struct type_9 {
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

struct type_11 {
    member: type_9,
}

struct type_15 {
    member: array<u32>,
}

struct type_20 {
    member: u32,
    member_1: u32,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> keys: type_15;
@group(0) @binding(2) 
var<storage, read_write> table: type_15;
var<workgroup> counts: array<atomic<u32>, 256>;

fn function_() {
    var phi_72_: type_20;
    var phi_73_: type_20;
    var phi_96_: type_20;
    var phi_139_: type_20;
    var phi_140_: type_20;
    var phi_163_: type_20;

    let _e27 = id_1;
    let _e28 = n_1;
    let _e29 = lane_1;
    let _e37 = ((_e27.y * _e28.x) + _e27.x);
    atomicStore((&counts[_e29]), 0u);
    atomicStore((&counts[(_e29 + 128u)]), 0u);
    workgroupBarrier();
    phi_72_ = type_20(0u, 16u);
    loop {
        let _e42 = phi_72_;
        if (_e42.member < _e42.member_1) {
            phi_73_ = type_20((_e42.member + 1u), _e42.member_1);
            phi_96_ = type_20(1u, _e42.member);
        } else {
            phi_73_ = _e42;
            phi_96_ = type_20(0u, type_20().member_1);
        }
        let _e56 = phi_73_;
        let _e58 = phi_96_;
        let _e62 = (bitcast<i32>(_e58.member) != 0i);
        if _e62 {
            let _e66 = (((_e37 * 2048u) + (_e58.member_1 * 128u)) + _e29);
            let _e68 = params.member.member_17;
            if (_e66 < _e68) {
                let _e71 = keys.member[_e66];
                let _e73 = params.member.member_10;
                let _e79 = atomicAdd((&counts[((_e71 >> bitcast<u32>((_e73 & 31u))) & 255u)]), 1u);
            }
        }
        continue;
        continuing {
            phi_72_ = _e56;
            break if !(_e62);
        }
    }
    workgroupBarrier();
    let _e82 = params.member.member_11;
    if (_e37 < _e82) {
        phi_139_ = type_20(0u, 2u);
        loop {
            let _e85 = phi_139_;
            if (_e85.member < _e85.member_1) {
                phi_140_ = type_20((_e85.member + 1u), _e85.member_1);
                phi_163_ = type_20(1u, _e85.member);
            } else {
                phi_140_ = _e85;
                phi_163_ = type_20(0u, type_20().member_1);
            }
            let _e99 = phi_140_;
            let _e101 = phi_163_;
            let _e105 = (bitcast<i32>(_e101.member) != 0i);
            if _e105 {
                let _e107 = (_e29 + (_e101.member_1 * 128u));
                let _e109 = params.member.member_11;
                let _e113 = atomicLoad((&counts[_e107]));
                table.member[((_e107 * _e109) + _e37)] = _e113;
            }
            continue;
            continuing {
                phi_139_ = _e99;
                break if !(_e105);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn sort_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
