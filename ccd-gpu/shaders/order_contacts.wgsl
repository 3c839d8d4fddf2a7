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

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
}

struct type_15 {
    member: type_7,
    member_1: type_8,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

struct type_17 {
    member: u32,
    member_1: bool,
}

struct type_20 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(2) 
var<storage> slots: type_11;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_11;
@group(0) @binding(4) 
var<storage, read_write> table: type_20;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_92_: u32;
    var phi_97_: u32;
    var phi_155_: type_9;
    var phi_158_: u32;
    var phi_160_: u32;
    var phi_156_: type_9;
    var phi_183_: type_9;
    var phi_253_: u32;
    var phi_254_: u32;
    var phi_255_: bool;
    var phi_256_: u32;
    var phi_257_: u32;
    var phi_258_: bool;
    var phi_159_: u32;
    var phi_161_: u32;
    var phi_259_: bool;
    var phi_266_: type_9;
    var phi_269_: u32;
    var phi_271_: u32;
    var phi_267_: type_9;
    var phi_294_: type_9;
    var phi_365_: u32;
    var phi_366_: u32;
    var phi_367_: bool;
    var phi_368_: u32;
    var phi_369_: u32;
    var phi_370_: bool;
    var phi_270_: u32;
    var phi_272_: u32;
    var phi_371_: bool;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_384_: type_17;
    var phi_411_: u32;
    var phi_431_: type_9;
    var phi_432_: type_9;
    var phi_455_: type_9;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e22 = id_2;
    let _e23 = n_2;
    let _e24 = lane_2;
    let _e36 = ((((_e22.y * _e23.x) + _e22.x) * 256u) + _e24);
    let _e39 = params.member.member_1.member;
    let _e42 = params.member.member_1.member_2;
    let _e44 = contacts.member[0u];
    if (_e42 < _e44) {
        phi_92_ = _e42;
    } else {
        phi_92_ = _e44;
    }
    let _e47 = phi_92_;
    if (_e47 < _e39) {
        phi_97_ = _e47;
    } else {
        phi_97_ = _e39;
    }
    let _e50 = phi_97_;
    if (_e36 < _e50) {
        let _e54 = slots.member[_e36];
        let _e55 = (7u * _e54);
        let _e58 = contacts.member[(4u + _e55)];
        let _e61 = params.member.member.member[0u];
        let _e65 = contacts.member[(_e55 + 6u)];
        let _e66 = ((_e58 * _e61) + _e65);
        let _e70 = contacts.member[((7u * _e54) + 7u)];
        phi_155_ = type_9(0u, 4097u);
        phi_158_ = 0u;
        phi_160_ = _e36;
        loop {
            let _e72 = phi_155_;
            let _e74 = phi_158_;
            let _e76 = phi_160_;
            local_4 = _e74;
            local_1 = _e76;
            local_2 = _e76;
            if (_e72.member < _e72.member_1) {
                phi_156_ = type_9((_e72.member + 1u), _e72.member_1);
                phi_183_ = type_9(1u, _e72.member);
            } else {
                phi_156_ = _e72;
                phi_183_ = type_9(0u, type_9().member_1);
            }
            let _e88 = phi_156_;
            let _e90 = phi_183_;
            if (bitcast<i32>(_e90.member) != 0i) {
                if (_e76 == 0u) {
                    phi_256_ = u32();
                    phi_257_ = u32();
                    phi_258_ = false;
                } else {
                    let _e97 = slots.member[(_e76 - 1u)];
                    let _e98 = (7u * _e97);
                    let _e101 = contacts.member[(4u + _e98)];
                    let _e104 = params.member.member.member[0u];
                    let _e108 = contacts.member[(_e98 + 6u)];
                    if (((_e101 * _e104) + _e108) != _e66) {
                        phi_253_ = u32();
                        phi_254_ = u32();
                        phi_255_ = false;
                    } else {
                        let _e115 = contacts.member[((7u * _e97) + 7u)];
                        phi_253_ = (_e74 + select(0u, 1u, (_e115 <= _e70)));
                        phi_254_ = (_e76 - 1u);
                        phi_255_ = true;
                    }
                    let _e120 = phi_253_;
                    let _e122 = phi_254_;
                    let _e124 = phi_255_;
                    phi_256_ = _e120;
                    phi_257_ = _e122;
                    phi_258_ = _e124;
                }
                let _e126 = phi_256_;
                let _e128 = phi_257_;
                let _e130 = phi_258_;
                phi_159_ = _e126;
                phi_161_ = _e128;
                phi_259_ = _e130;
            } else {
                phi_159_ = u32();
                phi_161_ = u32();
                phi_259_ = false;
            }
            let _e132 = phi_159_;
            let _e134 = phi_161_;
            let _e136 = phi_259_;
            continue;
            continuing {
                phi_155_ = _e88;
                phi_158_ = _e132;
                phi_160_ = _e134;
                break if !(_e136);
            }
        }
        phi_266_ = type_9(0u, 4097u);
        phi_269_ = _e36;
        let _e292 = local_4;
        phi_271_ = _e292;
        loop {
            let _e139 = phi_266_;
            let _e141 = phi_269_;
            let _e143 = phi_271_;
            local = _e141;
            local_3 = _e143;
            if (_e139.member < _e139.member_1) {
                phi_267_ = type_9((_e139.member + 1u), _e139.member_1);
                phi_294_ = type_9(1u, _e139.member);
            } else {
                phi_267_ = _e139;
                phi_294_ = type_9(0u, type_9().member_1);
            }
            let _e155 = phi_267_;
            let _e157 = phi_294_;
            if (bitcast<i32>(_e157.member) != 0i) {
                if ((_e141 + 1u) >= _e50) {
                    phi_368_ = u32();
                    phi_369_ = u32();
                    phi_370_ = false;
                } else {
                    let _e165 = slots.member[(_e141 + 1u)];
                    let _e166 = (7u * _e165);
                    let _e169 = contacts.member[(4u + _e166)];
                    let _e172 = params.member.member.member[0u];
                    let _e176 = contacts.member[(_e166 + 6u)];
                    if (((_e169 * _e172) + _e176) != _e66) {
                        phi_365_ = u32();
                        phi_366_ = u32();
                        phi_367_ = false;
                    } else {
                        let _e183 = contacts.member[((7u * _e165) + 7u)];
                        phi_365_ = (_e141 + 1u);
                        phi_366_ = (_e143 + select(0u, 1u, (_e183 < _e70)));
                        phi_367_ = true;
                    }
                    let _e188 = phi_365_;
                    let _e190 = phi_366_;
                    let _e192 = phi_367_;
                    phi_368_ = _e188;
                    phi_369_ = _e190;
                    phi_370_ = _e192;
                }
                let _e194 = phi_368_;
                let _e196 = phi_369_;
                let _e198 = phi_370_;
                phi_270_ = _e194;
                phi_272_ = _e196;
                phi_371_ = _e198;
            } else {
                phi_270_ = u32();
                phi_272_ = u32();
                phi_371_ = false;
            }
            let _e200 = phi_270_;
            let _e202 = phi_272_;
            let _e204 = phi_371_;
            continue;
            continuing {
                phi_266_ = _e155;
                phi_269_ = _e200;
                phi_271_ = _e202;
                break if !(_e204);
            }
        }
        let _e207 = local;
        let _e209 = local_1;
        if ((_e207 - _e209) > 4096u) {
            phi_384_ = type_17(_e36, false);
        } else {
            let _e213 = local_2;
            let _e215 = local_3;
            phi_384_ = type_17((_e213 + _e215), true);
        }
        let _e220 = phi_384_;
        if _e220.member_1 {
        } else {
            let _e226 = params.member.member.member[0u];
            let _e229 = params.member.member.member[1u];
            let _e230 = (_e226 + _e229);
            let _e231 = (_e230 / 256u);
            if ((_e230 % 256u) > 0u) {
                phi_411_ = (_e231 + 1u);
            } else {
                phi_411_ = _e231;
            }
            let _e236 = phi_411_;
            let _e240 = atomicOr((&table.member[((256u * _e236) + 256u)]), 1u);
        }
        let _e242 = slots.member[_e36];
        phi_431_ = type_9(0u, 7u);
        loop {
            let _e246 = phi_431_;
            if (_e246.member < _e246.member_1) {
                phi_432_ = type_9((_e246.member + 1u), _e246.member_1);
                phi_455_ = type_9(1u, _e246.member);
            } else {
                phi_432_ = _e246;
                phi_455_ = type_9(0u, type_9().member_1);
            }
            let _e258 = phi_432_;
            let _e260 = phi_455_;
            let _e264 = (bitcast<i32>(_e260.member) != 0i);
            if _e264 {
                let _e269 = contacts.member[((4u + (7u * _e242)) + _e260.member_1)];
                ordered.member[((7u * _e220.member) + _e260.member_1)] = _e269;
            }
            continue;
            continuing {
                phi_431_ = _e258;
                break if !(_e264);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
