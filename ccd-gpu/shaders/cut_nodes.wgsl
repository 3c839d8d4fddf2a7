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
    var phi_102_: type_8;
    var phi_125_: type_8;
    var phi_136_: type_8;
    var phi_137_: type_8;
    var phi_160_: type_8;
    var phi_225_: u32;
    var phi_232_: type_8;
    var phi_233_: type_8;
    var phi_256_: type_8;
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
        if (_e42.member < _e42.member_1) {
            phi_102_ = type_8((_e42.member + 1u), _e42.member_1);
            phi_125_ = type_8(1u, _e42.member);
        } else {
            phi_102_ = _e42;
            phi_125_ = type_8(0u, type_8().member_1);
        }
        let _e54 = phi_102_;
        let _e56 = phi_125_;
        let _e59 = (bitcast<i32>(_e56.member) != 0i);
        if _e59 {
            let _e61 = atomicLoad((&counters[0u]));
            workgroupBarrier();
            phi_136_ = type_8(0u, 4u);
            loop {
                let _e63 = phi_136_;
                if (_e63.member < _e63.member_1) {
                    phi_137_ = type_8((_e63.member + 1u), _e63.member_1);
                    phi_160_ = type_8(1u, _e63.member);
                } else {
                    phi_137_ = _e63;
                    phi_160_ = type_8(0u, type_8().member_1);
                }
                let _e75 = phi_137_;
                let _e77 = phi_160_;
                let _e81 = (bitcast<i32>(_e77.member) != 0i);
                if _e81 {
                    let _e83 = ((_e77.member_1 * 256u) + _e15);
                    if (_e83 < _e61) {
                        let _e86 = nodes[_e83];
                        if (_e86 < (_e30 - 1u)) {
                            let _e89 = branches.member[_e86];
                            if ((_e89.member_3 - _e89.member_2) >= (_e30 / _e34)) {
                                let _e95 = atomicAdd((&counters[1u]), 1u);
                                let _e96 = (_e61 + _e95);
                                let _e99 = params.member.member_2.member_2;
                                if (_e96 < _e99) {
                                    nodes[_e83] = _e89.member;
                                    nodes[_e96] = _e89.member_1;
                                }
                            }
                        }
                    }
                }
                continue;
                continuing {
                    phi_136_ = _e75;
                    break if !(_e81);
                }
            }
            workgroupBarrier();
            if (_e15 == 0u) {
                let _e108 = atomicLoad((&counters[1u]));
                let _e109 = (_e61 + _e108);
                let _e112 = params.member.member_2.member_2;
                if (_e112 < _e109) {
                    phi_225_ = _e112;
                } else {
                    phi_225_ = _e109;
                }
                let _e115 = phi_225_;
                atomicStore((&counters[0u]), _e115);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_101_ = _e54;
            break if !(_e59);
        }
    }
    let _e120 = atomicLoad((&counters[0u]));
    phi_232_ = type_8(0u, 4u);
    loop {
        let _e122 = phi_232_;
        if (_e122.member < _e122.member_1) {
            phi_233_ = type_8((_e122.member + 1u), _e122.member_1);
            phi_256_ = type_8(1u, _e122.member);
        } else {
            phi_233_ = _e122;
            phi_256_ = type_8(0u, type_8().member_1);
        }
        let _e134 = phi_233_;
        let _e136 = phi_256_;
        let _e140 = (bitcast<i32>(_e136.member) != 0i);
        if _e140 {
            let _e142 = ((_e136.member_1 * 256u) + _e15);
            if (_e142 < _e120) {
                let _e146 = nodes[_e142];
                cuts.member[((_e22 + 4u) + _e142)] = _e146;
            }
        }
        continue;
        continuing {
            phi_232_ = _e134;
            break if !(_e140);
        }
    }
    if (_e15 == 0u) {
        cuts.member[_e22] = _e120;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn cut_nodes(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
