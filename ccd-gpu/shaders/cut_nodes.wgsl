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

struct type_14 {
    member: array<type_7>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
    member_18: u32,
}

struct type_16 {
    member: type_6,
    member_1: type_7,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

@group(0) @binding(1) 
var<storage> branches: type_14;
@group(0) @binding(0) 
var<storage> params: type_17;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage, read_write> cuts: type_10;
var<workgroup> nodes: array<u32, 1024>;

fn function_(lane_1: u32) {
    var phi_101_: type_8;
    var phi_136_: type_8;
    var phi_232_: type_8;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e15 = lane_2;
    let _e21 = params.member.member_1.member_1;
    let _e22 = (_e21 * 1028u);
    let _e26 = params.member.member_2.member;
    let _e30 = params.member.member.member[_e26];
    let _e34 = params.member.member_2.member_2;
    if (_e34 == 0u) {
        return;
    }
    if (_e15 == 0u) {
        nodes[0u] = 0u;
        atomicStore((&counters[0u]), 1u);
        atomicStore((&counters[1u]), 0u);
    }
    workgroupBarrier();
    phi_101_ = type_8(0u, 32u);
    loop {
        let _e42 = phi_101_;
        let _e45 = (_e42.member < _e42.member_1);
        let _e56 = (bitcast<i32>(select(0u, 1u, _e45)) != 0i);
        if _e56 {
            let _e58 = atomicLoad((&counters[0u]));
            workgroupBarrier();
            phi_136_ = type_8(0u, 4u);
            loop {
                let _e60 = phi_136_;
                let _e63 = (_e60.member < _e60.member_1);
                let _e76 = (bitcast<i32>(select(0u, 1u, _e63)) != 0i);
                if _e76 {
                    let _e78 = ((select(type_8().member_1, _e60.member, _e63) * 256u) + _e15);
                    if (_e78 < _e58) {
                        let _e81 = nodes[_e78];
                        if (_e81 < (_e30 - 1u)) {
                            let _e84 = branches.member[_e81];
                            if ((_e84.member_3 - _e84.member_2) >= (_e30 / _e34)) {
                                let _e90 = atomicAdd((&counters[1u]), 1u);
                                let _e91 = (_e58 + _e90);
                                let _e94 = params.member.member_2.member_2;
                                if (_e91 < _e94) {
                                    nodes[_e78] = _e84.member;
                                    nodes[_e91] = _e84.member_1;
                                }
                            }
                        }
                    }
                }
                continue;
                continuing {
                    phi_136_ = type_8(select(_e60.member, (_e60.member + 1u), _e63), select(_e60.member_1, _e60.member_1, _e63));
                    break if !(_e76);
                }
            }
            workgroupBarrier();
            if (_e15 == 0u) {
                let _e103 = atomicLoad((&counters[1u]));
                let _e104 = (_e58 + _e103);
                let _e107 = params.member.member_2.member_2;
                atomicStore((&counters[0u]), select(_e104, _e107, (_e107 < _e104)));
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_101_ = type_8(select(_e42.member, (_e42.member + 1u), _e45), select(_e42.member_1, _e42.member_1, _e45));
            break if !(_e56);
        }
    }
    let _e114 = atomicLoad((&counters[0u]));
    phi_232_ = type_8(0u, 4u);
    loop {
        let _e116 = phi_232_;
        let _e119 = (_e116.member < _e116.member_1);
        let _e132 = (bitcast<i32>(select(0u, 1u, _e119)) != 0i);
        if _e132 {
            let _e134 = ((select(type_8().member_1, _e116.member, _e119) * 256u) + _e15);
            if (_e134 < _e114) {
                let _e138 = nodes[_e134];
                cuts.member[((_e22 + 4u) + _e134)] = _e138;
            }
        }
        continue;
        continuing {
            phi_232_ = type_8(select(_e116.member, (_e116.member + 1u), _e119), select(_e116.member_1, _e116.member_1, _e119));
            break if !(_e132);
        }
    }
    if (_e15 == 0u) {
        cuts.member[_e22] = _e114;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn cut_nodes(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
