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
    var phi_157_: type_8;
    var phi_160_: u32;
    var phi_158_: type_8;
    var phi_183_: type_8;
    var phi_226_: u32;
    var phi_161_: u32;
    var local: u32;
    var phi_230_: type_8;
    var phi_233_: u32;
    var phi_235_: u32;
    var phi_237_: u32;
    var phi_234_: u32;
    var phi_231_: type_8;
    var phi_260_: type_8;
    var phi_276_: u32;
    var phi_236_: u32;
    var phi_238_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_286_: type_8;
    var phi_289_: u32;
    var phi_287_: type_8;
    var phi_312_: type_8;
    var phi_366_: u32;
    var phi_290_: u32;
    var local_3: u32;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e18 = lane_2;
    let _e24 = params.member.member_2.member_7;
    let _e27 = params.member.member_2.member_13;
    let _e30 = params.member.member_1.member_1;
    let _e31 = (_e30 + 1u);
    let _e34 = (1u << bitcast<u32>((_e24 & 31u)));
    let _e36 = atomicLoad((&control.member[_e31]));
    let _e38 = ((_e34 + 255u) / 256u);
    phi_157_ = type_8(0u, _e38);
    phi_160_ = 0u;
    loop {
        let _e41 = phi_157_;
        let _e43 = phi_160_;
        local = _e43;
        local_3 = _e43;
        local_2 = _e43;
        if (_e41.member < _e41.member_1) {
            phi_158_ = type_8((_e41.member + 1u), _e41.member_1);
            phi_183_ = type_8(1u, _e41.member);
        } else {
            phi_158_ = _e41;
            phi_183_ = type_8(0u, type_8().member_1);
        }
        let _e55 = phi_158_;
        let _e57 = phi_183_;
        let _e61 = (bitcast<i32>(_e57.member) != 0i);
        if _e61 {
            let _e63 = ((_e18 * _e38) + _e57.member_1);
            if (_e63 < _e34) {
                let _e71 = ((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * _e63));
                let _e73 = atomicLoad((&control.member[_e71]));
                let _e76 = atomicLoad((&control.member[(_e71 + 1u)]));
                phi_226_ = (_e43 + (_e73 + _e76));
            } else {
                phi_226_ = _e43;
            }
            let _e80 = phi_226_;
            phi_161_ = _e80;
        } else {
            phi_161_ = u32();
        }
        let _e82 = phi_161_;
        continue;
        continuing {
            phi_157_ = _e55;
            phi_160_ = _e82;
            break if !(_e61);
        }
    }
    let _e86 = local;
    sums[_e18] = _e86;
    phi_230_ = type_8(0u, 8u);
    phi_233_ = 0u;
    phi_235_ = 1u;
    let _e234 = local_3;
    phi_237_ = _e234;
    phi_234_ = 256u;
    loop {
        let _e88 = phi_230_;
        let _e90 = phi_233_;
        let _e92 = phi_235_;
        let _e94 = phi_237_;
        let _e96 = phi_234_;
        local_1 = _e94;
        if (_e88.member < _e88.member_1) {
            phi_231_ = type_8((_e88.member + 1u), _e88.member_1);
            phi_260_ = type_8(1u, _e88.member);
        } else {
            phi_231_ = _e88;
            phi_260_ = type_8(0u, type_8().member_1);
        }
        let _e108 = phi_231_;
        let _e110 = phi_260_;
        let _e113 = (bitcast<i32>(_e110.member) != 0i);
        if _e113 {
            workgroupBarrier();
            if (_e18 >= _e92) {
                let _e118 = sums[((_e90 + _e18) - _e92)];
                phi_276_ = (_e94 + _e118);
            } else {
                phi_276_ = _e94;
            }
            let _e121 = phi_276_;
            sums[(_e96 + _e18)] = _e121;
            phi_236_ = (_e92 * 2u);
            phi_238_ = _e121;
        } else {
            phi_236_ = u32();
            phi_238_ = u32();
        }
        let _e126 = phi_236_;
        let _e128 = phi_238_;
        continue;
        continuing {
            phi_230_ = _e108;
            phi_233_ = _e96;
            phi_235_ = _e126;
            phi_237_ = _e128;
            phi_234_ = _e90;
            break if !(_e113);
        }
    }
    workgroupBarrier();
    let _e131 = local_1;
    let _e134 = local_2;
    let _e137 = sums[255u];
    phi_286_ = type_8(0u, _e38);
    phi_289_ = ((_e36 + _e131) - _e134);
    loop {
        let _e140 = phi_286_;
        let _e142 = phi_289_;
        if (_e140.member < _e140.member_1) {
            phi_287_ = type_8((_e140.member + 1u), _e140.member_1);
            phi_312_ = type_8(1u, _e140.member);
        } else {
            phi_287_ = _e140;
            phi_312_ = type_8(0u, type_8().member_1);
        }
        let _e154 = phi_287_;
        let _e156 = phi_312_;
        let _e160 = (bitcast<i32>(_e156.member) != 0i);
        if _e160 {
            let _e162 = ((_e18 * _e38) + _e156.member_1);
            if (_e162 < _e34) {
                atomicStore((&control.member[(((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + _e162)]), _e142);
                let _e182 = ((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * _e162));
                let _e184 = atomicLoad((&control.member[_e182]));
                let _e187 = atomicLoad((&control.member[(_e182 + 1u)]));
                phi_366_ = (_e142 + (_e184 + _e187));
            } else {
                phi_366_ = _e142;
            }
            let _e191 = phi_366_;
            phi_290_ = _e191;
        } else {
            phi_290_ = u32();
        }
        let _e193 = phi_290_;
        continue;
        continuing {
            phi_286_ = _e154;
            phi_289_ = _e193;
            break if !(_e160);
        }
    }
    if (_e18 == 0u) {
        atomicStore((&control.member[(((1540u + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + (2u * (1u << bitcast<u32>((_e24 & 31u))))) + _e34)]), (_e36 + _e137));
        if (_e137 > 0u) {
            let _e211 = atomicAdd((&control.member[_e31]), _e137);
            let _e214 = atomicMax((&nodes.member[0u]), (_e211 + _e137));
            if ((_e211 + _e137) < _e211) {
                let _e218 = atomicAdd((&nodes.member[2u]), 1u);
            }
            if (_e27 == 0u) {
            } else {
                let _e221 = atomicMax((&control.member[1536u]), 4294967295u);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn balance_counts(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
