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

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_7,
    member_1: type_8,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: array<vec4<u32>>,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(1) 
var<storage> branches: type_18;
@group(0) @binding(2) 
var<storage> block_nodes: type_22;
@group(0) @binding(3) 
var<storage, read_write> nodes: type_25;
@group(0) @binding(4) 
var<storage, read_write> far: type_31;
var<workgroup> boxes: array<type_27, 512>;
var<workgroup> counters: array<atomic<u32>, 2>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_159_: type_27;
    var phi_198_: type_8;
    var phi_233_: u32;
    var phi_234_: u32;
    var phi_235_: u32;
    var phi_236_: u32;
    var phi_237_: u32;
    var phi_238_: u32;
    var phi_239_: u32;
    var phi_240_: u32;
    var phi_243_: type_9;
    var phi_246_: type_27;
    var phi_248_: type_27;
    var phi_250_: type_27;
    var phi_365_: type_27;
    var phi_446_: type_27;
    var phi_247_: type_27;
    var phi_249_: type_27;
    var phi_251_: type_27;
    var local: type_27;
    var local_1: type_27;
    var local_2: type_27;
    var local_3: type_27;
    var phi_603_: u32;
    var phi_604_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e23 = id_2;
    let _e24 = n_2;
    let _e25 = lane_2;
    let _e36 = (((_e23.y * _e24.x) + _e23.x) * 256u);
    let _e37 = (_e36 + _e25);
    let _e40 = params.member.member_2.member_1;
    let _e44 = params.member.member.member[_e40];
    if (_e37 < _e44) {
        let _e50 = params.member.member_2.member[0u][_e40];
        let _e53 = block_nodes.member[(_e50 + _e37)];
        phi_159_ = type_27(array<f32, 3>(_e53.member.x, _e53.member.y, _e53.member_1.x), array<f32, 3>(_e53.member_1.y, _e53.member_2.x, _e53.member_2.y));
    } else {
        phi_159_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e70 = phi_159_;
    boxes[_e25] = type_27(array<f32, 3>(_e70.member[0], _e70.member[1], _e70.member[2]), array<f32, 3>(_e70.member_1[0], _e70.member_1[1], _e70.member_1[2]));
    if (_e25 == 0u) {
        atomicStore((&counters[0u]), 0u);
    }
    let _e86 = ((_e37 + 1u) < _e44);
    if _e86 {
        let _e89 = branches.member[_e37];
        phi_198_ = type_8(_e89.x, _e89.y, _e89.z, _e89.w);
    } else {
        phi_198_ = type_8(0u, 0u, _e36, _e36);
    }
    let _e96 = phi_198_;
    let _e102 = select(false, (_e96.member_3 < (_e36 + 256u)), (_e96.member_2 >= _e36));
    let _e103 = (_e44 - 1u);
    let _e109 = select(_e96.member, (_e96.member - _e103), (_e96.member >= _e103));
    if _e86 {
        if _e102 {
            phi_233_ = (_e96.member_3 - _e109);
            phi_234_ = ((_e109 + 1u) - _e36);
            phi_235_ = ((_e109 + 1u) - _e96.member_2);
            phi_236_ = (_e96.member_2 - _e36);
        } else {
            phi_233_ = 0u;
            phi_234_ = 0u;
            phi_235_ = 0u;
            phi_236_ = 0u;
        }
        let _e120 = phi_233_;
        let _e122 = phi_234_;
        let _e124 = phi_235_;
        let _e126 = phi_236_;
        phi_237_ = _e120;
        phi_238_ = _e122;
        phi_239_ = _e124;
        phi_240_ = _e126;
    } else {
        phi_237_ = 0u;
        phi_238_ = 0u;
        phi_239_ = 0u;
        phi_240_ = 0u;
    }
    let _e128 = phi_237_;
    let _e130 = phi_238_;
    let _e132 = phi_239_;
    let _e134 = phi_240_;
    workgroupBarrier();
    phi_243_ = type_9(0u, 9u);
    phi_246_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_248_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_250_ = _e70;
    loop {
        let _e136 = phi_243_;
        let _e138 = phi_246_;
        let _e140 = phi_248_;
        let _e142 = phi_250_;
        local = _e140;
        local_1 = _e140;
        local_2 = _e138;
        local_3 = _e138;
        let _e145 = (_e136.member < _e136.member_1);
        let _e156 = select(type_9().member_1, _e136.member, _e145);
        let _e158 = (bitcast<i32>(select(0u, 1u, _e145)) != 0i);
        if _e158 {
            let _e160 = ((_e156 & 1u) * 256u);
            let _e163 = (1u << bitcast<u32>((_e156 & 31u)));
            if ((_e132 >> bitcast<u32>((_e156 & 31u))) == 1u) {
                let _e168 = (_e160 + _e134);
                let _e170 = boxes[_e168];
                let _e182 = boxes[((_e168 + _e132) - _e163)];
                phi_365_ = type_27(array<f32, 3>(select(_e182.member[0], _e170.member[0], (_e170.member[0] < _e182.member[0])), select(_e182.member[1], _e170.member[1], (_e170.member[1] < _e182.member[1])), select(_e182.member[2], _e170.member[2], (_e170.member[2] < _e182.member[2]))), array<f32, 3>(select(_e182.member_1[0], _e170.member_1[0], (_e170.member_1[0] > _e182.member_1[0])), select(_e182.member_1[1], _e170.member_1[1], (_e170.member_1[1] > _e182.member_1[1])), select(_e182.member_1[2], _e170.member_1[2], (_e170.member_1[2] > _e182.member_1[2]))));
            } else {
                phi_365_ = _e140;
            }
            let _e207 = phi_365_;
            if ((_e128 >> bitcast<u32>((_e156 & 31u))) == 1u) {
                let _e212 = (_e160 + _e130);
                let _e214 = boxes[_e212];
                let _e226 = boxes[((_e212 + _e128) - _e163)];
                phi_446_ = type_27(array<f32, 3>(select(_e226.member[0], _e214.member[0], (_e214.member[0] < _e226.member[0])), select(_e226.member[1], _e214.member[1], (_e214.member[1] < _e226.member[1])), select(_e226.member[2], _e214.member[2], (_e214.member[2] < _e226.member[2]))), array<f32, 3>(select(_e226.member_1[0], _e214.member_1[0], (_e214.member_1[0] > _e226.member_1[0])), select(_e226.member_1[1], _e214.member_1[1], (_e214.member_1[1] > _e226.member_1[1])), select(_e226.member_1[2], _e214.member_1[2], (_e214.member_1[2] > _e226.member_1[2]))));
            } else {
                phi_446_ = _e138;
            }
            let _e251 = phi_446_;
            let _e252 = (_e25 + _e163);
            let _e257 = boxes[(_e160 + select(_e252, 255u, (255u < _e252)))];
            let _e269 = select(_e257.member[0], _e142.member[0], (_e142.member[0] < _e257.member[0]));
            let _e273 = select(_e257.member[1], _e142.member[1], (_e142.member[1] < _e257.member[1]));
            let _e277 = select(_e257.member[2], _e142.member[2], (_e142.member[2] < _e257.member[2]));
            let _e282 = select(_e257.member_1[0], _e142.member_1[0], (_e142.member_1[0] > _e257.member_1[0]));
            let _e286 = select(_e257.member_1[1], _e142.member_1[1], (_e142.member_1[1] > _e257.member_1[1]));
            let _e290 = select(_e257.member_1[2], _e142.member_1[2], (_e142.member_1[2] > _e257.member_1[2]));
            boxes[((256u - _e160) + _e25)] = type_27(array<f32, 3>(_e269, _e273, _e277), array<f32, 3>(_e282, _e286, _e290));
            workgroupBarrier();
            phi_247_ = _e251;
            phi_249_ = _e207;
            phi_251_ = type_27(array<f32, 3>(_e269, _e273, _e277), array<f32, 3>(_e282, _e286, _e290));
        } else {
            phi_247_ = type_27();
            phi_249_ = type_27();
            phi_251_ = type_27();
        }
        let _e300 = phi_247_;
        let _e302 = phi_249_;
        let _e304 = phi_251_;
        continue;
        continuing {
            phi_243_ = type_9(select(_e136.member, (_e136.member + 1u), _e145), select(_e136.member_1, _e136.member_1, _e145));
            phi_246_ = _e300;
            phi_248_ = _e302;
            phi_250_ = _e304;
            break if !(_e158);
        }
    }
    if _e86 {
        if _e102 {
            let _e306 = (_e44 - 1u);
            let _e313 = local;
            let _e321 = local_1;
            let _e329 = local_2;
            let _e332 = local_3;
            nodes.member[_e37] = type_23(vec4<u32>(bitcast<u32>(_e313.member[0]), bitcast<u32>(_e313.member[1]), bitcast<u32>(_e313.member[2]), select(_e96.member, ((_e96.member - _e306) | 2147483648u), (_e96.member >= _e306))), vec4<u32>(bitcast<u32>(_e321.member_1[0]), bitcast<u32>(_e321.member_1[1]), bitcast<u32>(_e321.member_1[2]), select(_e96.member_1, ((_e96.member_1 - _e306) | 2147483648u), (_e96.member_1 >= _e306))), vec4<u32>(bitcast<u32>(_e329.member[0]), bitcast<u32>(_e329.member[1]), bitcast<u32>(_e329.member[2]), _e109), vec4<u32>(bitcast<u32>(_e332.member_1[0]), bitcast<u32>(_e332.member_1[1]), bitcast<u32>(_e332.member_1[2]), (_e96.member_3 | select(0u, 2147483648u, ((_e109 - _e96.member_2) < (_e96.member_3 - _e109))))));
        }
    }
    if _e86 {
        if _e102 {
            phi_603_ = 0u;
        } else {
            let _e368 = atomicAdd((&counters[0u]), 1u);
            phi_603_ = _e368;
        }
        let _e370 = phi_603_;
        phi_604_ = _e370;
    } else {
        phi_604_ = 0u;
    }
    let _e372 = phi_604_;
    workgroupBarrier();
    if (_e25 == 0u) {
        let _e375 = atomicLoad((&counters[0u]));
        if (_e375 > 0u) {
            let _e378 = atomicAdd((&far.member[0u]), _e375);
            atomicStore((&counters[1u]), _e378);
        }
    }
    workgroupBarrier();
    if _e86 {
        if _e102 {
        } else {
            let _e381 = atomicLoad((&counters[1u]));
            atomicStore((&far.member[(4u + (_e381 + _e372))]), _e37);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn near_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
