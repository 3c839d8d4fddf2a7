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

struct type_11 {
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

struct type_12 {
    member: type_6,
    member_1: type_7,
    member_2: type_11,
}

struct type_13 {
    member: type_12,
}

struct type_16 {
    member: array<atomic<u32>>,
}

var<workgroup> sums: array<u32, 512>;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(2) 
var<storage, read_write> nodes: type_16;
@group(0) @binding(1) 
var<storage, read_write> control: type_16;

fn function_(lane_1: u32) {
    var phi_156_: u32;
    var phi_162_: type_8;
    var phi_165_: u32;
    var phi_231_: u32;
    var phi_166_: u32;
    var local: u32;
    var phi_236_: type_8;
    var phi_239_: u32;
    var phi_241_: u32;
    var phi_243_: u32;
    var phi_240_: u32;
    var phi_282_: u32;
    var phi_242_: u32;
    var phi_244_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_291_: type_8;
    var phi_294_: u32;
    var phi_371_: u32;
    var phi_295_: u32;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e18 = lane_2;
    let _e24 = params.member.member_2.member_7;
    let _e27 = params.member.member_2.member_13;
    let _e30 = params.member.member_1.member_1;
    let _e31 = (_e30 + 1u);
    let _e34 = (1u << bitcast<u32>((_e24 & 31u)));
    if (_e18 == 0u) {
        let _e37 = atomicLoad((&control.member[_e31]));
        phi_156_ = _e37;
    } else {
        phi_156_ = 0u;
    }
    let _e39 = phi_156_;
    let _e41 = ((_e34 + 255u) / 256u);
    phi_162_ = type_8(0u, _e41);
    phi_165_ = 0u;
    loop {
        let _e44 = phi_162_;
        let _e46 = phi_165_;
        local = _e46;
        local_2 = _e46;
        let _e49 = (_e44.member < _e44.member_1);
        let _e62 = (bitcast<i32>(select(0u, 1u, _e49)) != 0i);
        if _e62 {
            let _e64 = ((_e18 * _e41) + select(type_8().member_1, _e44.member, _e49));
            if (_e64 < _e34) {
                let _e72 = ((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * _e64));
                let _e74 = atomicLoad((&control.member[_e72]));
                let _e77 = atomicLoad((&control.member[(_e72 + 1u)]));
                phi_231_ = (_e46 + (_e74 + _e77));
            } else {
                phi_231_ = _e46;
            }
            let _e81 = phi_231_;
            phi_166_ = _e81;
        } else {
            phi_166_ = u32();
        }
        let _e83 = phi_166_;
        continue;
        continuing {
            phi_162_ = type_8(select(_e44.member, (_e44.member + 1u), _e49), select(_e44.member_1, _e44.member_1, _e49));
            phi_165_ = _e83;
            break if !(_e62);
        }
    }
    let _e86 = local;
    let _e87 = (_e39 + _e86);
    sums[_e18] = _e87;
    phi_236_ = type_8(0u, 8u);
    phi_239_ = 0u;
    phi_241_ = 1u;
    phi_243_ = _e87;
    phi_240_ = 256u;
    loop {
        let _e90 = phi_236_;
        let _e92 = phi_239_;
        let _e94 = phi_241_;
        let _e96 = phi_243_;
        let _e98 = phi_240_;
        local_1 = _e96;
        let _e101 = (_e90.member < _e90.member_1);
        let _e112 = (bitcast<i32>(select(0u, 1u, _e101)) != 0i);
        if _e112 {
            workgroupBarrier();
            if (_e18 >= _e94) {
                let _e117 = sums[((_e92 + _e18) - _e94)];
                phi_282_ = (_e96 + _e117);
            } else {
                phi_282_ = _e96;
            }
            let _e120 = phi_282_;
            sums[(_e98 + _e18)] = _e120;
            phi_242_ = (_e94 * 2u);
            phi_244_ = _e120;
        } else {
            phi_242_ = u32();
            phi_244_ = u32();
        }
        let _e125 = phi_242_;
        let _e127 = phi_244_;
        continue;
        continuing {
            phi_236_ = type_8(select(_e90.member, (_e90.member + 1u), _e101), select(_e90.member_1, _e90.member_1, _e101));
            phi_239_ = _e98;
            phi_241_ = _e125;
            phi_243_ = _e127;
            phi_240_ = _e92;
            break if !(_e112);
        }
    }
    workgroupBarrier();
    let _e130 = local_1;
    let _e132 = local_2;
    let _e135 = sums[255u];
    phi_291_ = type_8(0u, _e41);
    phi_294_ = (_e130 - _e132);
    loop {
        let _e138 = phi_291_;
        let _e140 = phi_294_;
        let _e143 = (_e138.member < _e138.member_1);
        let _e156 = (bitcast<i32>(select(0u, 1u, _e143)) != 0i);
        if _e156 {
            let _e158 = ((_e18 * _e41) + select(type_8().member_1, _e138.member, _e143));
            if (_e158 < _e34) {
                atomicStore((&control.member[(((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + _e158)]), _e140);
                let _e178 = ((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * _e158));
                let _e180 = atomicLoad((&control.member[_e178]));
                let _e183 = atomicLoad((&control.member[(_e178 + 1u)]));
                phi_371_ = (_e140 + (_e180 + _e183));
            } else {
                phi_371_ = _e140;
            }
            let _e187 = phi_371_;
            phi_295_ = _e187;
        } else {
            phi_295_ = u32();
        }
        let _e189 = phi_295_;
        continue;
        continuing {
            phi_291_ = type_8(select(_e138.member, (_e138.member + 1u), _e143), select(_e138.member_1, _e138.member_1, _e143));
            phi_294_ = _e189;
            break if !(_e156);
        }
    }
    if (_e18 == 0u) {
        atomicStore((&control.member[(((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + _e34)]), _e135);
        if (_e135 > _e39) {
            let _e205 = (_e135 - _e39);
            let _e207 = atomicAdd((&control.member[_e31]), _e205);
            let _e210 = atomicMax((&nodes.member[0u]), (_e207 + _e205));
            if ((_e207 + _e205) < _e207) {
                let _e214 = atomicAdd((&nodes.member[2u]), 1u);
            }
            if (_e27 == 0u) {
            } else {
                let _e217 = atomicMax((&control.member[1536u]), 4294967295u);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn balance_counts(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
