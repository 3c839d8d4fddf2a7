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
    member: type_6,
    member_1: type_7,
    member_2: type_7,
}

struct type_16 {
    member: type_15,
}

@group(0) @binding(1) 
var<storage> branches: type_14;
@group(0) @binding(0) 
var<storage> params: type_16;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage, read_write> cut: type_10;
var<workgroup> nodes: array<u32, 1024>;

fn function_(lane_1: u32) {
    var phi_87_: type_8;
    var phi_88_: type_8;
    var phi_111_: type_8;
    var phi_122_: type_8;
    var phi_123_: type_8;
    var phi_146_: type_8;
    var phi_211_: u32;
    var phi_218_: type_8;
    var phi_219_: type_8;
    var phi_242_: type_8;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e14 = lane_2;
    let _e20 = params.member.member_2.member;
    let _e24 = params.member.member.member[_e20];
    let _e28 = params.member.member_2.member_2;
    if (_e28 == 0u) {
        return;
    }
    if (_e14 == 0u) {
        nodes[0u] = 0u;
        atomicStore((&counters[0u]), 1u);
        atomicStore((&counters[1u]), 0u);
    }
    workgroupBarrier();
    phi_87_ = type_8(0u, 32u);
    loop {
        let _e36 = phi_87_;
        if (_e36.member < _e36.member_1) {
            phi_88_ = type_8((_e36.member + 1u), _e36.member_1);
            phi_111_ = type_8(1u, _e36.member);
        } else {
            phi_88_ = _e36;
            phi_111_ = type_8(0u, type_8().member_1);
        }
        let _e48 = phi_88_;
        let _e50 = phi_111_;
        let _e53 = (bitcast<i32>(_e50.member) != 0i);
        if _e53 {
            let _e55 = atomicLoad((&counters[0u]));
            workgroupBarrier();
            phi_122_ = type_8(0u, 4u);
            loop {
                let _e57 = phi_122_;
                if (_e57.member < _e57.member_1) {
                    phi_123_ = type_8((_e57.member + 1u), _e57.member_1);
                    phi_146_ = type_8(1u, _e57.member);
                } else {
                    phi_123_ = _e57;
                    phi_146_ = type_8(0u, type_8().member_1);
                }
                let _e69 = phi_123_;
                let _e71 = phi_146_;
                let _e75 = (bitcast<i32>(_e71.member) != 0i);
                if _e75 {
                    let _e77 = ((_e71.member_1 * 256u) + _e14);
                    if (_e77 < _e55) {
                        let _e80 = nodes[_e77];
                        if (_e80 < (_e24 - 1u)) {
                            let _e83 = branches.member[_e80];
                            if ((_e83.member_3 - _e83.member_2) >= (_e24 / _e28)) {
                                let _e89 = atomicAdd((&counters[1u]), 1u);
                                let _e90 = (_e55 + _e89);
                                let _e93 = params.member.member_2.member_2;
                                if (_e90 < _e93) {
                                    nodes[_e77] = _e83.member;
                                    nodes[_e90] = _e83.member_1;
                                }
                            }
                        }
                    }
                }
                continue;
                continuing {
                    phi_122_ = _e69;
                    break if !(_e75);
                }
            }
            workgroupBarrier();
            if (_e14 == 0u) {
                let _e102 = atomicLoad((&counters[1u]));
                let _e103 = (_e55 + _e102);
                let _e106 = params.member.member_2.member_2;
                if (_e106 < _e103) {
                    phi_211_ = _e106;
                } else {
                    phi_211_ = _e103;
                }
                let _e109 = phi_211_;
                atomicStore((&counters[0u]), _e109);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_87_ = _e48;
            break if !(_e53);
        }
    }
    let _e114 = atomicLoad((&counters[0u]));
    phi_218_ = type_8(0u, 4u);
    loop {
        let _e116 = phi_218_;
        if (_e116.member < _e116.member_1) {
            phi_219_ = type_8((_e116.member + 1u), _e116.member_1);
            phi_242_ = type_8(1u, _e116.member);
        } else {
            phi_219_ = _e116;
            phi_242_ = type_8(0u, type_8().member_1);
        }
        let _e128 = phi_219_;
        let _e130 = phi_242_;
        let _e134 = (bitcast<i32>(_e130.member) != 0i);
        if _e134 {
            let _e136 = ((_e130.member_1 * 256u) + _e14);
            if (_e136 < _e114) {
                let _e140 = nodes[_e136];
                cut.member[(4u + _e136)] = _e140;
            }
        }
        continue;
        continuing {
            phi_218_ = _e128;
            break if !(_e134);
        }
    }
    if (_e14 == 0u) {
        cut.member[0u] = _e114;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn cut_nodes(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
