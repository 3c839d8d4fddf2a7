// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_6 {
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

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<vec4<u32>>,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_6,
    member_1: type_7,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_19 {
    member: f32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(2) 
var<storage, read_write> found: type_10;
@group(0) @binding(1) 
var<storage, read_write> items: type_15;
var<workgroup> least: array<atomic<u32>, 3>;

fn function_(lane_1: u32) {
    var phi_129_: type_8;
    var phi_132_: type_19;
    var phi_215_: type_19;
    var phi_216_: bool;
    var phi_225_: type_19;
    var phi_133_: type_19;
    var local: type_19;
    var local_1: type_19;
    var local_2: type_19;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e17 = lane_2;
    if (_e17 == 0u) {
        atomicStore((&least[0u]), 2137108966u);
        atomicStore((&least[1u]), 4294967295u);
        let _e25 = found.member[0u];
        atomicStore((&least[2u]), (_e25 + 1u));
    }
    workgroupBarrier();
    let _e29 = atomicLoad((&least[2u]));
    let _e32 = params.member.member_1.member;
    let _e33 = (_e32 - _e29);
    let _e34 = (_e33 / 256u);
    let _e38 = select(_e34, (_e34 + 1u), ((_e33 % 256u) > 0u));
    let _e40 = (_e38 / 256u);
    phi_129_ = type_8(0u, select(_e40, (_e40 + 1u), ((_e38 % 256u) > 0u)));
    phi_132_ = type_19(300000000000000000000000000000000000000f, _e29);
    loop {
        let _e47 = phi_129_;
        let _e49 = phi_132_;
        local = _e49;
        local_1 = _e49;
        local_2 = _e49;
        let _e52 = (_e47.member < _e47.member_1);
        let _e65 = (bitcast<i32>(select(0u, 1u, _e52)) != 0i);
        if _e65 {
            let _e67 = ((select(type_8().member_1, _e47.member, _e52) * 256u) + _e17);
            if (_e67 < _e38) {
                let _e69 = (2u * _e67);
                let _e72 = found.member[(1u + _e69)];
                let _e73 = bitcast<f32>(_e72);
                let _e76 = found.member[(_e69 + 2u)];
                if (_e73 < _e49.member) {
                    phi_215_ = type_19();
                    phi_216_ = true;
                } else {
                    let _e83 = select(true, select(true, false, (_e76 < _e49.member_1)), (_e73 == _e49.member));
                    phi_215_ = type_19(select(type_19().member, _e49.member, _e83), select(type_19().member_1, _e49.member_1, _e83));
                    phi_216_ = select(true, false, _e83);
                }
                let _e93 = phi_215_;
                let _e95 = phi_216_;
                phi_225_ = type_19(select(_e93.member, _e73, _e95), select(_e93.member_1, _e76, _e95));
            } else {
                phi_225_ = _e49;
            }
            let _e102 = phi_225_;
            phi_133_ = _e102;
        } else {
            phi_133_ = type_19();
        }
        let _e104 = phi_133_;
        continue;
        continuing {
            phi_129_ = type_8(select(_e47.member, (_e47.member + 1u), _e52), select(_e47.member_1, _e47.member_1, _e52));
            phi_132_ = _e104;
            break if !(_e65);
        }
    }
    let _e107 = local;
    let _e111 = atomicMin((&least[0u]), bitcast<u32>(_e107.member));
    workgroupBarrier();
    let _e113 = local_1;
    let _e117 = atomicLoad((&least[0u]));
    if (bitcast<u32>(_e113.member) == _e117) {
        let _e120 = local_2;
        let _e123 = atomicMin((&least[1u]), _e120.member_1);
    }
    workgroupBarrier();
    if (_e17 == 0u) {
        let _e126 = atomicLoad((&least[1u]));
        let _e128 = items.member[_e29];
        let _e130 = items.member[_e126];
        items.member[_e126] = _e128;
        items.member[_e29] = _e130;
        found.member[0u] = (_e29 + 1u);
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_swap(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
