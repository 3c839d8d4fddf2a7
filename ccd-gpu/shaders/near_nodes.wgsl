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

struct type_25 {
    member: array<vec2<u32>>,
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
var<workgroup> words: array<vec2<u32>, 1024>;
var<workgroup> counters: array<atomic<u32>, 2>;

fn function_(param: bool, param_1: u32) -> u32 {
    return select(0u, param_1, param);
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_165_: type_27;
    var phi_218_: type_8;
    var phi_253_: u32;
    var phi_254_: u32;
    var phi_255_: u32;
    var phi_256_: u32;
    var phi_257_: u32;
    var phi_258_: u32;
    var phi_259_: u32;
    var phi_260_: u32;
    var phi_263_: type_9;
    var phi_266_: type_27;
    var phi_268_: type_27;
    var phi_270_: type_27;
    var phi_420_: type_27;
    var phi_538_: type_27;
    var phi_267_: type_27;
    var phi_269_: type_27;
    var phi_271_: type_27;
    var local: type_27;
    var local_1: type_27;
    var local_2: type_27;
    var local_3: type_27;
    var phi_675_: type_9;
    var phi_795_: type_9;
    var phi_870_: u32;
    var phi_871_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e46 = (((_e33.y * _e34.x) + _e33.x) * 256u);
    let _e47 = (_e46 + _e35);
    let _e50 = params.member.member_2.member_1;
    let _e54 = params.member.member.member[_e50];
    if (_e47 < _e54) {
        let _e60 = params.member.member_2.member[0u][_e50];
        let _e63 = block_nodes.member[(_e60 + _e47)];
        phi_165_ = type_27(array<f32, 3>(_e63.member.x, _e63.member.y, _e63.member_1.x), array<f32, 3>(_e63.member_1.y, _e63.member_2.x, _e63.member_2.y));
    } else {
        phi_165_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    }
    let _e80 = phi_165_;
    words[(3u * _e35)][0u] = bitcast<u32>(_e80.member[0]);
    words[(3u * _e35)][1u] = bitcast<u32>(_e80.member[1]);
    words[((3u * _e35) + 1u)][0u] = bitcast<u32>(_e80.member[2]);
    words[((3u * _e35) + 1u)][1u] = bitcast<u32>(_e80.member_1[0]);
    words[((3u * _e35) + 2u)][0u] = bitcast<u32>(_e80.member_1[1]);
    words[((3u * _e35) + 2u)][1u] = bitcast<u32>(_e80.member_1[2]);
    if (_e35 == 0u) {
        atomicStore((&counters[0u]), 0u);
    }
    let _e116 = ((_e47 + 1u) < _e54);
    if _e116 {
        let _e119 = branches.member[_e47];
        phi_218_ = type_8(_e119.x, _e119.y, _e119.z, _e119.w);
    } else {
        phi_218_ = type_8(0u, 0u, _e46, _e46);
    }
    let _e126 = phi_218_;
    let _e132 = select(false, (_e126.member_3 < (_e46 + 256u)), (_e126.member_2 >= _e46));
    let _e133 = (_e54 - 1u);
    let _e139 = select(_e126.member, (_e126.member - _e133), (_e126.member >= _e133));
    if _e116 {
        if _e132 {
            phi_253_ = (_e126.member_3 - _e139);
            phi_254_ = ((_e139 + 1u) - _e46);
            phi_255_ = ((_e139 + 1u) - _e126.member_2);
            phi_256_ = (_e126.member_2 - _e46);
        } else {
            phi_253_ = 0u;
            phi_254_ = 0u;
            phi_255_ = 0u;
            phi_256_ = 0u;
        }
        let _e150 = phi_253_;
        let _e152 = phi_254_;
        let _e154 = phi_255_;
        let _e156 = phi_256_;
        phi_257_ = _e150;
        phi_258_ = _e152;
        phi_259_ = _e154;
        phi_260_ = _e156;
    } else {
        phi_257_ = 0u;
        phi_258_ = 0u;
        phi_259_ = 0u;
        phi_260_ = 0u;
    }
    let _e158 = phi_257_;
    let _e160 = phi_258_;
    let _e162 = phi_259_;
    let _e164 = phi_260_;
    workgroupBarrier();
    phi_263_ = type_9(0u, 9u);
    phi_266_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_268_ = type_27(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    phi_270_ = _e80;
    loop {
        let _e166 = phi_263_;
        let _e168 = phi_266_;
        let _e170 = phi_268_;
        let _e172 = phi_270_;
        local = _e170;
        local_1 = _e170;
        local_2 = _e168;
        local_3 = _e168;
        let _e175 = (_e166.member < _e166.member_1);
        let _e186 = select(type_9().member_1, _e166.member, _e175);
        let _e188 = (bitcast<i32>(select(0u, 1u, _e175)) != 0i);
        if _e188 {
            let _e191 = (1u << bitcast<u32>((_e186 & 31u)));
            if ((_e162 >> bitcast<u32>((_e186 & 31u))) == 1u) {
                let _e199 = words[(3u * _e164)][0u];
                let _e201 = words[(3u * _e164)][1u];
                let _e206 = words[((3u * _e164) + 1u)][0u];
                let _e208 = words[((3u * _e164) + 1u)][1u];
                let _e213 = words[((3u * _e164) + 2u)][0u];
                let _e215 = words[((3u * _e164) + 2u)][1u];
                let _e216 = bitcast<f32>(_e199);
                let _e217 = bitcast<f32>(_e201);
                let _e218 = bitcast<f32>(_e206);
                let _e219 = bitcast<f32>(_e208);
                let _e220 = bitcast<f32>(_e213);
                let _e221 = bitcast<f32>(_e215);
                let _e223 = ((_e164 + _e162) - _e191);
                let _e227 = words[(3u * _e223)][0u];
                let _e229 = words[(3u * _e223)][1u];
                let _e234 = words[((3u * _e223) + 1u)][0u];
                let _e236 = words[((3u * _e223) + 1u)][1u];
                let _e241 = words[((3u * _e223) + 2u)][0u];
                let _e243 = words[((3u * _e223) + 2u)][1u];
                let _e244 = bitcast<f32>(_e227);
                let _e245 = bitcast<f32>(_e229);
                let _e246 = bitcast<f32>(_e234);
                let _e247 = bitcast<f32>(_e236);
                let _e248 = bitcast<f32>(_e241);
                let _e249 = bitcast<f32>(_e243);
                phi_420_ = type_27(array<f32, 3>(select(_e244, _e216, (_e216 < _e244)), select(_e245, _e217, (_e217 < _e245)), select(_e246, _e218, (_e218 < _e246))), array<f32, 3>(select(_e247, _e219, (_e219 > _e247)), select(_e248, _e220, (_e220 > _e248)), select(_e249, _e221, (_e221 > _e249))));
            } else {
                phi_420_ = _e170;
            }
            let _e266 = phi_420_;
            if ((_e158 >> bitcast<u32>((_e186 & 31u))) == 1u) {
                let _e274 = words[(3u * _e160)][0u];
                let _e276 = words[(3u * _e160)][1u];
                let _e281 = words[((3u * _e160) + 1u)][0u];
                let _e283 = words[((3u * _e160) + 1u)][1u];
                let _e288 = words[((3u * _e160) + 2u)][0u];
                let _e290 = words[((3u * _e160) + 2u)][1u];
                let _e291 = bitcast<f32>(_e274);
                let _e292 = bitcast<f32>(_e276);
                let _e293 = bitcast<f32>(_e281);
                let _e294 = bitcast<f32>(_e283);
                let _e295 = bitcast<f32>(_e288);
                let _e296 = bitcast<f32>(_e290);
                let _e298 = ((_e160 + _e158) - _e191);
                let _e302 = words[(3u * _e298)][0u];
                let _e304 = words[(3u * _e298)][1u];
                let _e309 = words[((3u * _e298) + 1u)][0u];
                let _e311 = words[((3u * _e298) + 1u)][1u];
                let _e316 = words[((3u * _e298) + 2u)][0u];
                let _e318 = words[((3u * _e298) + 2u)][1u];
                let _e319 = bitcast<f32>(_e302);
                let _e320 = bitcast<f32>(_e304);
                let _e321 = bitcast<f32>(_e309);
                let _e322 = bitcast<f32>(_e311);
                let _e323 = bitcast<f32>(_e316);
                let _e324 = bitcast<f32>(_e318);
                phi_538_ = type_27(array<f32, 3>(select(_e319, _e291, (_e291 < _e319)), select(_e320, _e292, (_e292 < _e320)), select(_e321, _e293, (_e293 < _e321))), array<f32, 3>(select(_e322, _e294, (_e294 > _e322)), select(_e323, _e295, (_e295 > _e323)), select(_e324, _e296, (_e296 > _e324))));
            } else {
                phi_538_ = _e168;
            }
            let _e341 = phi_538_;
            let _e342 = (_e35 + _e191);
            let _e344 = select(_e342, 255u, (255u < _e342));
            let _e348 = words[(3u * _e344)][0u];
            let _e350 = words[(3u * _e344)][1u];
            let _e355 = words[((3u * _e344) + 1u)][0u];
            let _e357 = words[((3u * _e344) + 1u)][1u];
            let _e362 = words[((3u * _e344) + 2u)][0u];
            let _e364 = words[((3u * _e344) + 2u)][1u];
            let _e365 = bitcast<f32>(_e348);
            let _e366 = bitcast<f32>(_e350);
            let _e367 = bitcast<f32>(_e355);
            let _e368 = bitcast<f32>(_e357);
            let _e369 = bitcast<f32>(_e362);
            let _e370 = bitcast<f32>(_e364);
            let _e374 = select(_e365, _e172.member[0], (_e172.member[0] < _e365));
            let _e378 = select(_e366, _e172.member[1], (_e172.member[1] < _e366));
            let _e382 = select(_e367, _e172.member[2], (_e172.member[2] < _e367));
            let _e387 = select(_e368, _e172.member_1[0], (_e172.member_1[0] > _e368));
            let _e391 = select(_e369, _e172.member_1[1], (_e172.member_1[1] > _e369));
            let _e395 = select(_e370, _e172.member_1[2], (_e172.member_1[2] > _e370));
            workgroupBarrier();
            words[(3u * _e35)][0u] = bitcast<u32>(_e374);
            words[(3u * _e35)][1u] = bitcast<u32>(_e378);
            words[((3u * _e35) + 1u)][0u] = bitcast<u32>(_e382);
            words[((3u * _e35) + 1u)][1u] = bitcast<u32>(_e387);
            words[((3u * _e35) + 2u)][0u] = bitcast<u32>(_e391);
            words[((3u * _e35) + 2u)][1u] = bitcast<u32>(_e395);
            workgroupBarrier();
            phi_267_ = _e341;
            phi_269_ = _e266;
            phi_271_ = type_27(array<f32, 3>(_e374, _e378, _e382), array<f32, 3>(_e387, _e391, _e395));
        } else {
            phi_267_ = type_27();
            phi_269_ = type_27();
            phi_271_ = type_27();
        }
        let _e419 = phi_267_;
        let _e421 = phi_269_;
        let _e423 = phi_271_;
        continue;
        continuing {
            phi_263_ = type_9(select(_e166.member, (_e166.member + 1u), _e175), select(_e166.member_1, _e166.member_1, _e175));
            phi_266_ = _e419;
            phi_268_ = _e421;
            phi_270_ = _e423;
            break if !(_e188);
        }
    }
    let _e425 = (_e54 - 1u);
    let _e427 = local;
    let _e430 = local_1;
    let _e433 = local_2;
    let _e436 = local_3;
    let _e440 = function_((_e126.member >= _e425), 1u);
    let _e443 = function_((_e126.member_1 >= _e425), 2u);
    let _e450 = function_(((_e139 - _e126.member_2) < (_e126.member_3 - _e139)), 4u);
    phi_675_ = type_9(0u, 2u);
    loop {
        let _e456 = phi_675_;
        let _e459 = (_e456.member < _e456.member_1);
        let _e470 = select(type_9().member_1, _e456.member, _e459);
        let _e472 = (bitcast<i32>(select(0u, 1u, _e459)) != 0i);
        if _e472 {
            if ((_e35 / 128u) == _e470) {
                let _e475 = (_e35 % 128u);
                words[((8u * _e475) + (_e475 % 8u))][0u] = bitcast<u32>(_e427.member[0]);
                words[((8u * _e475) + (_e475 % 8u))][1u] = bitcast<u32>(_e427.member[1]);
                words[((8u * _e475) + (1u ^ (_e475 % 8u)))][0u] = bitcast<u32>(_e427.member[2]);
                words[((8u * _e475) + (1u ^ (_e475 % 8u)))][1u] = 0u;
                words[((8u * _e475) + (2u ^ (_e475 % 8u)))][0u] = bitcast<u32>(_e430.member_1[0]);
                words[((8u * _e475) + (2u ^ (_e475 % 8u)))][1u] = bitcast<u32>(_e430.member_1[1]);
                words[((8u * _e475) + (3u ^ (_e475 % 8u)))][0u] = bitcast<u32>(_e430.member_1[2]);
                words[((8u * _e475) + (3u ^ (_e475 % 8u)))][1u] = 0u;
                words[((8u * _e475) + (4u ^ (_e475 % 8u)))][0u] = bitcast<u32>(_e433.member[0]);
                words[((8u * _e475) + (4u ^ (_e475 % 8u)))][1u] = bitcast<u32>(_e433.member[1]);
                words[((8u * _e475) + (5u ^ (_e475 % 8u)))][0u] = bitcast<u32>(_e433.member[2]);
                words[((8u * _e475) + (5u ^ (_e475 % 8u)))][1u] = _e139;
                words[((8u * _e475) + (6u ^ (_e475 % 8u)))][0u] = bitcast<u32>(_e436.member_1[0]);
                words[((8u * _e475) + (6u ^ (_e475 % 8u)))][1u] = bitcast<u32>(_e436.member_1[1]);
                words[((8u * _e475) + (7u ^ (_e475 % 8u)))][0u] = bitcast<u32>(_e436.member_1[2]);
                words[((8u * _e475) + (7u ^ (_e475 % 8u)))][1u] = select(((_e440 | _e443) | _e450), 4294967295u, select(true, select(true, false, _e132), _e116));
            }
            workgroupBarrier();
            phi_795_ = type_9(0u, 4u);
            loop {
                let _e556 = phi_795_;
                let _e559 = (_e556.member < _e556.member_1);
                let _e572 = (bitcast<i32>(select(0u, 1u, _e559)) != 0i);
                if _e572 {
                    let _e574 = ((select(type_9().member_1, _e556.member, _e559) * 256u) + _e35);
                    let _e575 = (_e574 / 8u);
                    let _e582 = words[((8u * _e575) + (7u ^ (_e575 % 8u)))][1u];
                    if (_e582 != 4294967295u) {
                        let _e588 = (_e574 / 8u);
                        let _e596 = words[((8u * _e588) + ((_e574 % 8u) ^ (_e588 % 8u)))][0u];
                        let _e598 = words[((8u * _e588) + ((_e574 % 8u) ^ (_e588 % 8u)))][1u];
                        nodes.member[(((_e46 + (_e470 * 128u)) * 8u) + _e574)][0u] = _e596;
                        nodes.member[(((_e46 + (_e470 * 128u)) * 8u) + _e574)][1u] = _e598;
                    }
                }
                continue;
                continuing {
                    phi_795_ = type_9(select(_e556.member, (_e556.member + 1u), _e559), select(_e556.member_1, _e556.member_1, _e559));
                    break if !(_e572);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_675_ = type_9(select(_e456.member, (_e456.member + 1u), _e459), select(_e456.member_1, _e456.member_1, _e459));
            break if !(_e472);
        }
    }
    if _e116 {
        if _e132 {
            phi_870_ = 0u;
        } else {
            let _e605 = atomicAdd((&counters[0u]), 1u);
            phi_870_ = _e605;
        }
        let _e607 = phi_870_;
        phi_871_ = _e607;
    } else {
        phi_871_ = 0u;
    }
    let _e609 = phi_871_;
    workgroupBarrier();
    if (_e35 == 0u) {
        let _e612 = atomicLoad((&counters[0u]));
        if (_e612 > 0u) {
            let _e615 = atomicAdd((&far.member[0u]), _e612);
            atomicStore((&counters[1u]), _e615);
        }
    }
    workgroupBarrier();
    if _e116 {
        if _e132 {
        } else {
            let _e618 = atomicLoad((&counters[1u]));
            atomicStore((&far.member[(4u + (_e618 + _e609))]), _e47);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn near_nodes(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
