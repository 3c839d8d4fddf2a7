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
    var phi_163_: type_8;
    var phi_188_: type_8;
    var phi_231_: u32;
    var phi_166_: u32;
    var local: u32;
    var phi_236_: type_8;
    var phi_239_: u32;
    var phi_241_: u32;
    var phi_243_: u32;
    var phi_240_: u32;
    var phi_237_: type_8;
    var phi_266_: type_8;
    var phi_282_: u32;
    var phi_242_: u32;
    var phi_244_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_291_: type_8;
    var phi_294_: u32;
    var phi_292_: type_8;
    var phi_317_: type_8;
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
        if (_e44.member < _e44.member_1) {
            phi_163_ = type_8((_e44.member + 1u), _e44.member_1);
            phi_188_ = type_8(1u, _e44.member);
        } else {
            phi_163_ = _e44;
            phi_188_ = type_8(0u, type_8().member_1);
        }
        let _e58 = phi_163_;
        let _e60 = phi_188_;
        let _e64 = (bitcast<i32>(_e60.member) != 0i);
        if _e64 {
            let _e66 = ((_e18 * _e41) + _e60.member_1);
            if (_e66 < _e34) {
                let _e74 = ((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * _e66));
                let _e76 = atomicLoad((&control.member[_e74]));
                let _e79 = atomicLoad((&control.member[(_e74 + 1u)]));
                phi_231_ = (_e46 + (_e76 + _e79));
            } else {
                phi_231_ = _e46;
            }
            let _e83 = phi_231_;
            phi_166_ = _e83;
        } else {
            phi_166_ = u32();
        }
        let _e85 = phi_166_;
        continue;
        continuing {
            phi_162_ = _e58;
            phi_165_ = _e85;
            break if !(_e64);
        }
    }
    let _e88 = local;
    let _e89 = (_e39 + _e88);
    sums[_e18] = _e89;
    phi_236_ = type_8(0u, 8u);
    phi_239_ = 0u;
    phi_241_ = 1u;
    phi_243_ = _e89;
    phi_240_ = 256u;
    loop {
        let _e92 = phi_236_;
        let _e94 = phi_239_;
        let _e96 = phi_241_;
        let _e98 = phi_243_;
        let _e100 = phi_240_;
        local_1 = _e98;
        if (_e92.member < _e92.member_1) {
            phi_237_ = type_8((_e92.member + 1u), _e92.member_1);
            phi_266_ = type_8(1u, _e92.member);
        } else {
            phi_237_ = _e92;
            phi_266_ = type_8(0u, type_8().member_1);
        }
        let _e112 = phi_237_;
        let _e114 = phi_266_;
        let _e117 = (bitcast<i32>(_e114.member) != 0i);
        if _e117 {
            workgroupBarrier();
            if (_e18 >= _e96) {
                let _e122 = sums[((_e94 + _e18) - _e96)];
                phi_282_ = (_e98 + _e122);
            } else {
                phi_282_ = _e98;
            }
            let _e125 = phi_282_;
            sums[(_e100 + _e18)] = _e125;
            phi_242_ = (_e96 * 2u);
            phi_244_ = _e125;
        } else {
            phi_242_ = u32();
            phi_244_ = u32();
        }
        let _e130 = phi_242_;
        let _e132 = phi_244_;
        continue;
        continuing {
            phi_236_ = _e112;
            phi_239_ = _e100;
            phi_241_ = _e130;
            phi_243_ = _e132;
            phi_240_ = _e94;
            break if !(_e117);
        }
    }
    workgroupBarrier();
    let _e135 = local_1;
    let _e137 = local_2;
    let _e140 = sums[255u];
    phi_291_ = type_8(0u, _e41);
    phi_294_ = (_e135 - _e137);
    loop {
        let _e143 = phi_291_;
        let _e145 = phi_294_;
        if (_e143.member < _e143.member_1) {
            phi_292_ = type_8((_e143.member + 1u), _e143.member_1);
            phi_317_ = type_8(1u, _e143.member);
        } else {
            phi_292_ = _e143;
            phi_317_ = type_8(0u, type_8().member_1);
        }
        let _e157 = phi_292_;
        let _e159 = phi_317_;
        let _e163 = (bitcast<i32>(_e159.member) != 0i);
        if _e163 {
            let _e165 = ((_e18 * _e41) + _e159.member_1);
            if (_e165 < _e34) {
                atomicStore((&control.member[(((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + _e165)]), _e145);
                let _e185 = ((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * _e165));
                let _e187 = atomicLoad((&control.member[_e185]));
                let _e190 = atomicLoad((&control.member[(_e185 + 1u)]));
                phi_371_ = (_e145 + (_e187 + _e190));
            } else {
                phi_371_ = _e145;
            }
            let _e194 = phi_371_;
            phi_295_ = _e194;
        } else {
            phi_295_ = u32();
        }
        let _e196 = phi_295_;
        continue;
        continuing {
            phi_291_ = _e157;
            phi_294_ = _e196;
            break if !(_e163);
        }
    }
    if (_e18 == 0u) {
        atomicStore((&control.member[(((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + _e34)]), _e140);
        if (_e140 > _e39) {
            let _e212 = (_e140 - _e39);
            let _e214 = atomicAdd((&control.member[_e31]), _e212);
            let _e217 = atomicMax((&nodes.member[0u]), (_e214 + _e212));
            if ((_e214 + _e212) < _e214) {
                let _e221 = atomicAdd((&nodes.member[2u]), 1u);
            }
            if (_e27 == 0u) {
            } else {
                let _e224 = atomicMax((&control.member[1536u]), 4294967295u);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn balance_counts(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
