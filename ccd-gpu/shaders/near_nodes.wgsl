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
    var phi_151_: type_27;
    var phi_190_: type_8;
    var phi_199_: bool;
    var phi_209_: u32;
    var phi_225_: u32;
    var phi_226_: u32;
    var phi_227_: u32;
    var phi_228_: u32;
    var phi_229_: u32;
    var phi_230_: u32;
    var phi_231_: u32;
    var phi_232_: u32;
    var phi_235_: type_9;
    var phi_238_: type_27;
    var phi_240_: type_27;
    var phi_242_: type_27;
    var phi_236_: type_9;
    var phi_265_: type_9;
    var phi_318_: f32;
    var phi_325_: f32;
    var phi_332_: f32;
    var phi_340_: f32;
    var phi_347_: f32;
    var phi_354_: f32;
    var phi_357_: type_27;
    var phi_399_: f32;
    var phi_406_: f32;
    var phi_413_: f32;
    var phi_421_: f32;
    var phi_428_: f32;
    var phi_435_: f32;
    var phi_438_: type_27;
    var phi_444_: u32;
    var phi_465_: f32;
    var phi_472_: f32;
    var phi_479_: f32;
    var phi_487_: f32;
    var phi_494_: f32;
    var phi_501_: f32;
    var phi_239_: type_27;
    var phi_241_: type_27;
    var phi_243_: type_27;
    var local: type_27;
    var phi_538_: u32;
    var local_1: type_27;
    var phi_547_: u32;
    var local_2: type_27;
    var local_3: type_27;
    var phi_554_: u32;
    var phi_595_: u32;
    var phi_596_: u32;
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
    let _e41 = params.member.member.member[1u];
    if (_e37 < _e41) {
        let _e47 = params.member.member_2.member[0u][1u];
        let _e50 = block_nodes.member[(_e47 + _e37)];
        phi_151_ = type_27(array<f32, 3>(_e50.member.x, _e50.member.y, _e50.member_1.x), array<f32, 3>(_e50.member_1.y, _e50.member_2.x, _e50.member_2.y));
    } else {
        phi_151_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e67 = phi_151_;
    boxes[_e25] = type_27(array<f32, 3>(_e67.member[0], _e67.member[1], _e67.member[2]), array<f32, 3>(_e67.member_1[0], _e67.member_1[1], _e67.member_1[2]));
    if (_e25 == 0u) {
        atomicStore((&counters[0u]), 0u);
    }
    let _e83 = ((_e37 + 1u) < _e41);
    if _e83 {
        let _e86 = branches.member[_e37];
        phi_190_ = type_8(_e86.x, _e86.y, _e86.z, _e86.w);
    } else {
        phi_190_ = type_8(0u, 0u, _e36, _e36);
    }
    let _e93 = phi_190_;
    if (_e93.member_2 >= _e36) {
        phi_199_ = (_e93.member_3 < (_e36 + 256u));
    } else {
        phi_199_ = false;
    }
    let _e100 = phi_199_;
    let _e101 = (_e41 - 1u);
    if (_e93.member >= _e101) {
        phi_209_ = (_e93.member - _e101);
    } else {
        phi_209_ = _e93.member;
    }
    let _e108 = phi_209_;
    if _e83 {
        if _e100 {
            phi_225_ = (_e93.member_3 - _e108);
            phi_226_ = ((_e108 + 1u) - _e36);
            phi_227_ = ((_e108 + 1u) - _e93.member_2);
            phi_228_ = (_e93.member_2 - _e36);
        } else {
            phi_225_ = 0u;
            phi_226_ = 0u;
            phi_227_ = 0u;
            phi_228_ = 0u;
        }
        let _e119 = phi_225_;
        let _e121 = phi_226_;
        let _e123 = phi_227_;
        let _e125 = phi_228_;
        phi_229_ = _e119;
        phi_230_ = _e121;
        phi_231_ = _e123;
        phi_232_ = _e125;
    } else {
        phi_229_ = 0u;
        phi_230_ = 0u;
        phi_231_ = 0u;
        phi_232_ = 0u;
    }
    let _e127 = phi_229_;
    let _e129 = phi_230_;
    let _e131 = phi_231_;
    let _e133 = phi_232_;
    workgroupBarrier();
    phi_235_ = type_9(0u, 9u);
    phi_238_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_240_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_242_ = _e67;
    loop {
        let _e135 = phi_235_;
        let _e137 = phi_238_;
        let _e139 = phi_240_;
        let _e141 = phi_242_;
        local = _e139;
        local_1 = _e139;
        local_2 = _e137;
        local_3 = _e137;
        if (_e135.member < _e135.member_1) {
            phi_236_ = type_9((_e135.member + 1u), _e135.member_1);
            phi_265_ = type_9(1u, _e135.member);
        } else {
            phi_236_ = _e135;
            phi_265_ = type_9(0u, type_9().member_1);
        }
        let _e153 = phi_236_;
        let _e155 = phi_265_;
        let _e159 = (bitcast<i32>(_e155.member) != 0i);
        if _e159 {
            let _e161 = ((_e155.member_1 & 1u) * 256u);
            let _e164 = (1u << bitcast<u32>((_e155.member_1 & 31u)));
            if ((_e131 >> bitcast<u32>((_e155.member_1 & 31u))) == 1u) {
                let _e169 = (_e161 + _e133);
                let _e171 = boxes[_e169];
                let _e183 = boxes[((_e169 + _e131) - _e164)];
                if (_e171.member[0] < _e183.member[0]) {
                    phi_318_ = _e171.member[0];
                } else {
                    phi_318_ = _e183.member[0];
                }
                let _e194 = phi_318_;
                if (_e171.member[1] < _e183.member[1]) {
                    phi_325_ = _e171.member[1];
                } else {
                    phi_325_ = _e183.member[1];
                }
                let _e197 = phi_325_;
                if (_e171.member[2] < _e183.member[2]) {
                    phi_332_ = _e171.member[2];
                } else {
                    phi_332_ = _e183.member[2];
                }
                let _e200 = phi_332_;
                if (_e171.member_1[0] > _e183.member_1[0]) {
                    phi_340_ = _e171.member_1[0];
                } else {
                    phi_340_ = _e183.member_1[0];
                }
                let _e204 = phi_340_;
                if (_e171.member_1[1] > _e183.member_1[1]) {
                    phi_347_ = _e171.member_1[1];
                } else {
                    phi_347_ = _e183.member_1[1];
                }
                let _e207 = phi_347_;
                if (_e171.member_1[2] > _e183.member_1[2]) {
                    phi_354_ = _e171.member_1[2];
                } else {
                    phi_354_ = _e183.member_1[2];
                }
                let _e210 = phi_354_;
                phi_357_ = type_27(array<f32, 3>(_e194, _e197, _e200), array<f32, 3>(_e204, _e207, _e210));
            } else {
                phi_357_ = _e139;
            }
            let _e214 = phi_357_;
            if ((_e127 >> bitcast<u32>((_e155.member_1 & 31u))) == 1u) {
                let _e219 = (_e161 + _e129);
                let _e221 = boxes[_e219];
                let _e233 = boxes[((_e219 + _e127) - _e164)];
                if (_e221.member[0] < _e233.member[0]) {
                    phi_399_ = _e221.member[0];
                } else {
                    phi_399_ = _e233.member[0];
                }
                let _e244 = phi_399_;
                if (_e221.member[1] < _e233.member[1]) {
                    phi_406_ = _e221.member[1];
                } else {
                    phi_406_ = _e233.member[1];
                }
                let _e247 = phi_406_;
                if (_e221.member[2] < _e233.member[2]) {
                    phi_413_ = _e221.member[2];
                } else {
                    phi_413_ = _e233.member[2];
                }
                let _e250 = phi_413_;
                if (_e221.member_1[0] > _e233.member_1[0]) {
                    phi_421_ = _e221.member_1[0];
                } else {
                    phi_421_ = _e233.member_1[0];
                }
                let _e254 = phi_421_;
                if (_e221.member_1[1] > _e233.member_1[1]) {
                    phi_428_ = _e221.member_1[1];
                } else {
                    phi_428_ = _e233.member_1[1];
                }
                let _e257 = phi_428_;
                if (_e221.member_1[2] > _e233.member_1[2]) {
                    phi_435_ = _e221.member_1[2];
                } else {
                    phi_435_ = _e233.member_1[2];
                }
                let _e260 = phi_435_;
                phi_438_ = type_27(array<f32, 3>(_e244, _e247, _e250), array<f32, 3>(_e254, _e257, _e260));
            } else {
                phi_438_ = _e137;
            }
            let _e264 = phi_438_;
            let _e265 = (_e25 + _e164);
            if (255u < _e265) {
                phi_444_ = 255u;
            } else {
                phi_444_ = _e265;
            }
            let _e268 = phi_444_;
            let _e271 = boxes[(_e161 + _e268)];
            if (_e141.member[0] < _e271.member[0]) {
                phi_465_ = _e141.member[0];
            } else {
                phi_465_ = _e271.member[0];
            }
            let _e284 = phi_465_;
            if (_e141.member[1] < _e271.member[1]) {
                phi_472_ = _e141.member[1];
            } else {
                phi_472_ = _e271.member[1];
            }
            let _e289 = phi_472_;
            if (_e141.member[2] < _e271.member[2]) {
                phi_479_ = _e141.member[2];
            } else {
                phi_479_ = _e271.member[2];
            }
            let _e294 = phi_479_;
            if (_e141.member_1[0] > _e271.member_1[0]) {
                phi_487_ = _e141.member_1[0];
            } else {
                phi_487_ = _e271.member_1[0];
            }
            let _e300 = phi_487_;
            if (_e141.member_1[1] > _e271.member_1[1]) {
                phi_494_ = _e141.member_1[1];
            } else {
                phi_494_ = _e271.member_1[1];
            }
            let _e305 = phi_494_;
            if (_e141.member_1[2] > _e271.member_1[2]) {
                phi_501_ = _e141.member_1[2];
            } else {
                phi_501_ = _e271.member_1[2];
            }
            let _e310 = phi_501_;
            boxes[((256u - _e161) + _e25)] = type_27(array<f32, 3>(_e284, _e289, _e294), array<f32, 3>(_e300, _e305, _e310));
            workgroupBarrier();
            phi_239_ = _e264;
            phi_241_ = _e214;
            phi_243_ = type_27(array<f32, 3>(_e284, _e289, _e294), array<f32, 3>(_e300, _e305, _e310));
        } else {
            phi_239_ = type_27();
            phi_241_ = type_27();
            phi_243_ = type_27();
        }
        let _e320 = phi_239_;
        let _e322 = phi_241_;
        let _e324 = phi_243_;
        continue;
        continuing {
            phi_235_ = _e153;
            phi_238_ = _e320;
            phi_240_ = _e322;
            phi_242_ = _e324;
            break if !(_e159);
        }
    }
    if _e83 {
        if _e100 {
            let _e326 = (_e41 - 1u);
            let _e333 = local;
            if (_e93.member >= _e326) {
                phi_538_ = ((_e93.member - _e326) | 2147483648u);
            } else {
                phi_538_ = _e93.member;
            }
            let _e340 = phi_538_;
            let _e342 = local_1;
            if (_e93.member_1 >= _e326) {
                phi_547_ = ((_e93.member_1 - _e326) | 2147483648u);
            } else {
                phi_547_ = _e93.member_1;
            }
            let _e349 = phi_547_;
            let _e351 = local_2;
            let _e354 = local_3;
            if ((_e108 - _e93.member_2) < (_e93.member_3 - _e108)) {
                phi_554_ = 2147483648u;
            } else {
                phi_554_ = 0u;
            }
            let _e358 = phi_554_;
            nodes.member[_e37] = type_23(vec4<u32>(bitcast<u32>(_e333.member[0]), bitcast<u32>(_e333.member[1]), bitcast<u32>(_e333.member[2]), _e340), vec4<u32>(bitcast<u32>(_e342.member_1[0]), bitcast<u32>(_e342.member_1[1]), bitcast<u32>(_e342.member_1[2]), _e349), vec4<u32>(bitcast<u32>(_e351.member[0]), bitcast<u32>(_e351.member[1]), bitcast<u32>(_e351.member[2]), _e108), vec4<u32>(bitcast<u32>(_e354.member_1[0]), bitcast<u32>(_e354.member_1[1]), bitcast<u32>(_e354.member_1[2]), (_e93.member_3 | _e358)));
        }
    }
    if _e83 {
        if _e100 {
            phi_595_ = 0u;
        } else {
            let _e391 = atomicAdd((&counters[0u]), 1u);
            phi_595_ = _e391;
        }
        let _e393 = phi_595_;
        phi_596_ = _e393;
    } else {
        phi_596_ = 0u;
    }
    let _e395 = phi_596_;
    workgroupBarrier();
    if (_e25 == 0u) {
        let _e398 = atomicLoad((&counters[0u]));
        if (_e398 > 0u) {
            let _e401 = atomicAdd((&far.member[0u]), _e398);
            atomicStore((&counters[1u]), _e401);
        }
    }
    workgroupBarrier();
    if _e83 {
        if _e100 {
        } else {
            let _e404 = atomicLoad((&counters[1u]));
            atomicStore((&far.member[(4u + (_e404 + _e395))]), _e37);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn near_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
