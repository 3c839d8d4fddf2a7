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

struct type_13 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_14 {
    member: type_7,
    member_1: type_8,
    member_2: type_13,
}

struct type_15 {
    member: type_14,
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
var<storage> params: type_15;
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
    var phi_207_: bool;
    var phi_217_: u32;
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
    var phi_244_: type_9;
    var phi_273_: type_9;
    var phi_326_: f32;
    var phi_333_: f32;
    var phi_340_: f32;
    var phi_348_: f32;
    var phi_355_: f32;
    var phi_362_: f32;
    var phi_365_: type_27;
    var phi_407_: f32;
    var phi_414_: f32;
    var phi_421_: f32;
    var phi_429_: f32;
    var phi_436_: f32;
    var phi_443_: f32;
    var phi_446_: type_27;
    var phi_452_: u32;
    var phi_473_: f32;
    var phi_480_: f32;
    var phi_487_: f32;
    var phi_495_: f32;
    var phi_502_: f32;
    var phi_509_: f32;
    var phi_247_: type_27;
    var phi_249_: type_27;
    var phi_251_: type_27;
    var local: type_27;
    var phi_546_: u32;
    var local_1: type_27;
    var phi_555_: u32;
    var local_2: type_27;
    var local_3: type_27;
    var phi_562_: u32;
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
    if (_e96.member_2 >= _e36) {
        phi_207_ = (_e96.member_3 < (_e36 + 256u));
    } else {
        phi_207_ = false;
    }
    let _e103 = phi_207_;
    let _e104 = (_e44 - 1u);
    if (_e96.member >= _e104) {
        phi_217_ = (_e96.member - _e104);
    } else {
        phi_217_ = _e96.member;
    }
    let _e111 = phi_217_;
    if _e86 {
        if _e103 {
            phi_233_ = (_e96.member_3 - _e111);
            phi_234_ = ((_e111 + 1u) - _e36);
            phi_235_ = ((_e111 + 1u) - _e96.member_2);
            phi_236_ = (_e96.member_2 - _e36);
        } else {
            phi_233_ = 0u;
            phi_234_ = 0u;
            phi_235_ = 0u;
            phi_236_ = 0u;
        }
        let _e122 = phi_233_;
        let _e124 = phi_234_;
        let _e126 = phi_235_;
        let _e128 = phi_236_;
        phi_237_ = _e122;
        phi_238_ = _e124;
        phi_239_ = _e126;
        phi_240_ = _e128;
    } else {
        phi_237_ = 0u;
        phi_238_ = 0u;
        phi_239_ = 0u;
        phi_240_ = 0u;
    }
    let _e130 = phi_237_;
    let _e132 = phi_238_;
    let _e134 = phi_239_;
    let _e136 = phi_240_;
    workgroupBarrier();
    phi_243_ = type_9(0u, 9u);
    phi_246_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_248_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_250_ = _e70;
    loop {
        let _e138 = phi_243_;
        let _e140 = phi_246_;
        let _e142 = phi_248_;
        let _e144 = phi_250_;
        local = _e142;
        local_1 = _e142;
        local_2 = _e140;
        local_3 = _e140;
        if (_e138.member < _e138.member_1) {
            phi_244_ = type_9((_e138.member + 1u), _e138.member_1);
            phi_273_ = type_9(1u, _e138.member);
        } else {
            phi_244_ = _e138;
            phi_273_ = type_9(0u, type_9().member_1);
        }
        let _e156 = phi_244_;
        let _e158 = phi_273_;
        let _e162 = (bitcast<i32>(_e158.member) != 0i);
        if _e162 {
            let _e164 = ((_e158.member_1 & 1u) * 256u);
            let _e167 = (1u << bitcast<u32>((_e158.member_1 & 31u)));
            if ((_e134 >> bitcast<u32>((_e158.member_1 & 31u))) == 1u) {
                let _e172 = (_e164 + _e136);
                let _e174 = boxes[_e172];
                let _e186 = boxes[((_e172 + _e134) - _e167)];
                if (_e174.member[0] < _e186.member[0]) {
                    phi_326_ = _e174.member[0];
                } else {
                    phi_326_ = _e186.member[0];
                }
                let _e197 = phi_326_;
                if (_e174.member[1] < _e186.member[1]) {
                    phi_333_ = _e174.member[1];
                } else {
                    phi_333_ = _e186.member[1];
                }
                let _e200 = phi_333_;
                if (_e174.member[2] < _e186.member[2]) {
                    phi_340_ = _e174.member[2];
                } else {
                    phi_340_ = _e186.member[2];
                }
                let _e203 = phi_340_;
                if (_e174.member_1[0] > _e186.member_1[0]) {
                    phi_348_ = _e174.member_1[0];
                } else {
                    phi_348_ = _e186.member_1[0];
                }
                let _e207 = phi_348_;
                if (_e174.member_1[1] > _e186.member_1[1]) {
                    phi_355_ = _e174.member_1[1];
                } else {
                    phi_355_ = _e186.member_1[1];
                }
                let _e210 = phi_355_;
                if (_e174.member_1[2] > _e186.member_1[2]) {
                    phi_362_ = _e174.member_1[2];
                } else {
                    phi_362_ = _e186.member_1[2];
                }
                let _e213 = phi_362_;
                phi_365_ = type_27(array<f32, 3>(_e197, _e200, _e203), array<f32, 3>(_e207, _e210, _e213));
            } else {
                phi_365_ = _e142;
            }
            let _e217 = phi_365_;
            if ((_e130 >> bitcast<u32>((_e158.member_1 & 31u))) == 1u) {
                let _e222 = (_e164 + _e132);
                let _e224 = boxes[_e222];
                let _e236 = boxes[((_e222 + _e130) - _e167)];
                if (_e224.member[0] < _e236.member[0]) {
                    phi_407_ = _e224.member[0];
                } else {
                    phi_407_ = _e236.member[0];
                }
                let _e247 = phi_407_;
                if (_e224.member[1] < _e236.member[1]) {
                    phi_414_ = _e224.member[1];
                } else {
                    phi_414_ = _e236.member[1];
                }
                let _e250 = phi_414_;
                if (_e224.member[2] < _e236.member[2]) {
                    phi_421_ = _e224.member[2];
                } else {
                    phi_421_ = _e236.member[2];
                }
                let _e253 = phi_421_;
                if (_e224.member_1[0] > _e236.member_1[0]) {
                    phi_429_ = _e224.member_1[0];
                } else {
                    phi_429_ = _e236.member_1[0];
                }
                let _e257 = phi_429_;
                if (_e224.member_1[1] > _e236.member_1[1]) {
                    phi_436_ = _e224.member_1[1];
                } else {
                    phi_436_ = _e236.member_1[1];
                }
                let _e260 = phi_436_;
                if (_e224.member_1[2] > _e236.member_1[2]) {
                    phi_443_ = _e224.member_1[2];
                } else {
                    phi_443_ = _e236.member_1[2];
                }
                let _e263 = phi_443_;
                phi_446_ = type_27(array<f32, 3>(_e247, _e250, _e253), array<f32, 3>(_e257, _e260, _e263));
            } else {
                phi_446_ = _e140;
            }
            let _e267 = phi_446_;
            let _e268 = (_e25 + _e167);
            if (255u < _e268) {
                phi_452_ = 255u;
            } else {
                phi_452_ = _e268;
            }
            let _e271 = phi_452_;
            let _e274 = boxes[(_e164 + _e271)];
            if (_e144.member[0] < _e274.member[0]) {
                phi_473_ = _e144.member[0];
            } else {
                phi_473_ = _e274.member[0];
            }
            let _e287 = phi_473_;
            if (_e144.member[1] < _e274.member[1]) {
                phi_480_ = _e144.member[1];
            } else {
                phi_480_ = _e274.member[1];
            }
            let _e292 = phi_480_;
            if (_e144.member[2] < _e274.member[2]) {
                phi_487_ = _e144.member[2];
            } else {
                phi_487_ = _e274.member[2];
            }
            let _e297 = phi_487_;
            if (_e144.member_1[0] > _e274.member_1[0]) {
                phi_495_ = _e144.member_1[0];
            } else {
                phi_495_ = _e274.member_1[0];
            }
            let _e303 = phi_495_;
            if (_e144.member_1[1] > _e274.member_1[1]) {
                phi_502_ = _e144.member_1[1];
            } else {
                phi_502_ = _e274.member_1[1];
            }
            let _e308 = phi_502_;
            if (_e144.member_1[2] > _e274.member_1[2]) {
                phi_509_ = _e144.member_1[2];
            } else {
                phi_509_ = _e274.member_1[2];
            }
            let _e313 = phi_509_;
            boxes[((256u - _e164) + _e25)] = type_27(array<f32, 3>(_e287, _e292, _e297), array<f32, 3>(_e303, _e308, _e313));
            workgroupBarrier();
            phi_247_ = _e267;
            phi_249_ = _e217;
            phi_251_ = type_27(array<f32, 3>(_e287, _e292, _e297), array<f32, 3>(_e303, _e308, _e313));
        } else {
            phi_247_ = type_27();
            phi_249_ = type_27();
            phi_251_ = type_27();
        }
        let _e323 = phi_247_;
        let _e325 = phi_249_;
        let _e327 = phi_251_;
        continue;
        continuing {
            phi_243_ = _e156;
            phi_246_ = _e323;
            phi_248_ = _e325;
            phi_250_ = _e327;
            break if !(_e162);
        }
    }
    if _e86 {
        if _e103 {
            let _e329 = (_e44 - 1u);
            let _e336 = local;
            if (_e96.member >= _e329) {
                phi_546_ = ((_e96.member - _e329) | 2147483648u);
            } else {
                phi_546_ = _e96.member;
            }
            let _e343 = phi_546_;
            let _e345 = local_1;
            if (_e96.member_1 >= _e329) {
                phi_555_ = ((_e96.member_1 - _e329) | 2147483648u);
            } else {
                phi_555_ = _e96.member_1;
            }
            let _e352 = phi_555_;
            let _e354 = local_2;
            let _e357 = local_3;
            if ((_e111 - _e96.member_2) < (_e96.member_3 - _e111)) {
                phi_562_ = 2147483648u;
            } else {
                phi_562_ = 0u;
            }
            let _e361 = phi_562_;
            nodes.member[_e37] = type_23(vec4<u32>(bitcast<u32>(_e336.member[0]), bitcast<u32>(_e336.member[1]), bitcast<u32>(_e336.member[2]), _e343), vec4<u32>(bitcast<u32>(_e345.member_1[0]), bitcast<u32>(_e345.member_1[1]), bitcast<u32>(_e345.member_1[2]), _e352), vec4<u32>(bitcast<u32>(_e354.member[0]), bitcast<u32>(_e354.member[1]), bitcast<u32>(_e354.member[2]), _e111), vec4<u32>(bitcast<u32>(_e357.member_1[0]), bitcast<u32>(_e357.member_1[1]), bitcast<u32>(_e357.member_1[2]), (_e96.member_3 | _e361)));
        }
    }
    if _e86 {
        if _e103 {
            phi_603_ = 0u;
        } else {
            let _e394 = atomicAdd((&counters[0u]), 1u);
            phi_603_ = _e394;
        }
        let _e396 = phi_603_;
        phi_604_ = _e396;
    } else {
        phi_604_ = 0u;
    }
    let _e398 = phi_604_;
    workgroupBarrier();
    if (_e25 == 0u) {
        let _e401 = atomicLoad((&counters[0u]));
        if (_e401 > 0u) {
            let _e404 = atomicAdd((&far.member[0u]), _e401);
            atomicStore((&counters[1u]), _e404);
        }
    }
    workgroupBarrier();
    if _e86 {
        if _e103 {
        } else {
            let _e407 = atomicLoad((&counters[1u]));
            atomicStore((&far.member[(4u + (_e407 + _e398))]), _e37);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn near_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
