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

struct type_16 {
    member: array<vec4<u32>>,
}

struct type_17 {
    member: u32,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_20 {
    member: u32,
    member_1: bool,
}

struct type_23 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> contacts: type_11;
@group(0) @binding(2) 
var<storage> slots: type_11;
@group(0) @binding(3) 
var<storage, read_write> ordered: type_16;
@group(0) @binding(4) 
var<storage, read_write> table: type_23;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: u32;
    var phi_107_: u32;
    var phi_112_: u32;
    var phi_170_: type_9;
    var phi_173_: u32;
    var phi_175_: u32;
    var phi_171_: type_9;
    var phi_198_: type_9;
    var phi_268_: u32;
    var phi_269_: u32;
    var phi_270_: bool;
    var phi_271_: u32;
    var phi_272_: u32;
    var phi_273_: bool;
    var phi_174_: u32;
    var phi_176_: u32;
    var phi_274_: bool;
    var phi_281_: type_9;
    var phi_284_: u32;
    var phi_286_: u32;
    var phi_282_: type_9;
    var phi_309_: type_9;
    var phi_380_: u32;
    var phi_381_: u32;
    var phi_382_: bool;
    var phi_383_: u32;
    var phi_384_: u32;
    var phi_385_: bool;
    var phi_285_: u32;
    var phi_287_: u32;
    var phi_386_: bool;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_399_: type_20;
    var phi_426_: u32;
    var local_5: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e28 = id_2;
    let _e29 = n_2;
    let _e30 = lane_2;
    let _e42 = ((((_e28.y * _e29.x) + _e28.x) * 256u) + _e30);
    let _e45 = params.member.member_1.member;
    let _e48 = params.member.member_1.member_2;
    let _e50 = contacts.member[0u];
    if (_e48 < _e50) {
        phi_107_ = _e48;
    } else {
        phi_107_ = _e50;
    }
    let _e53 = phi_107_;
    if (_e53 < _e45) {
        phi_112_ = _e53;
    } else {
        phi_112_ = _e45;
    }
    let _e56 = phi_112_;
    if (_e42 < _e56) {
        let _e60 = slots.member[_e42];
        let _e61 = (7u * _e60);
        let _e64 = contacts.member[(4u + _e61)];
        let _e67 = params.member.member.member[0u];
        let _e71 = contacts.member[(_e61 + 6u)];
        let _e72 = ((_e64 * _e67) + _e71);
        let _e76 = contacts.member[((7u * _e60) + 7u)];
        phi_170_ = type_9(0u, 4097u);
        phi_173_ = 0u;
        phi_175_ = _e42;
        loop {
            let _e78 = phi_170_;
            let _e80 = phi_173_;
            let _e82 = phi_175_;
            local_5 = _e80;
            local_2 = _e82;
            local_3 = _e82;
            if (_e78.member < _e78.member_1) {
                phi_171_ = type_9((_e78.member + 1u), _e78.member_1);
                phi_198_ = type_9(1u, _e78.member);
            } else {
                phi_171_ = _e78;
                phi_198_ = type_9(0u, type_9().member_1);
            }
            let _e94 = phi_171_;
            let _e96 = phi_198_;
            if (bitcast<i32>(_e96.member) != 0i) {
                if (_e82 == 0u) {
                    phi_271_ = u32();
                    phi_272_ = u32();
                    phi_273_ = false;
                } else {
                    let _e103 = slots.member[(_e82 - 1u)];
                    let _e104 = (7u * _e103);
                    let _e107 = contacts.member[(4u + _e104)];
                    let _e110 = params.member.member.member[0u];
                    let _e114 = contacts.member[(_e104 + 6u)];
                    if (((_e107 * _e110) + _e114) != _e72) {
                        phi_268_ = u32();
                        phi_269_ = u32();
                        phi_270_ = false;
                    } else {
                        let _e121 = contacts.member[((7u * _e103) + 7u)];
                        phi_268_ = (_e80 + select(0u, 1u, (_e121 <= _e76)));
                        phi_269_ = (_e82 - 1u);
                        phi_270_ = true;
                    }
                    let _e126 = phi_268_;
                    let _e128 = phi_269_;
                    let _e130 = phi_270_;
                    phi_271_ = _e126;
                    phi_272_ = _e128;
                    phi_273_ = _e130;
                }
                let _e132 = phi_271_;
                let _e134 = phi_272_;
                let _e136 = phi_273_;
                phi_174_ = _e132;
                phi_176_ = _e134;
                phi_274_ = _e136;
            } else {
                phi_174_ = u32();
                phi_176_ = u32();
                phi_274_ = false;
            }
            let _e138 = phi_174_;
            let _e140 = phi_176_;
            let _e142 = phi_274_;
            continue;
            continuing {
                phi_170_ = _e94;
                phi_173_ = _e138;
                phi_175_ = _e140;
                break if !(_e142);
            }
        }
        phi_281_ = type_9(0u, 4097u);
        phi_284_ = _e42;
        let _e310 = local_5;
        phi_286_ = _e310;
        loop {
            let _e145 = phi_281_;
            let _e147 = phi_284_;
            let _e149 = phi_286_;
            local_1 = _e147;
            local_4 = _e149;
            if (_e145.member < _e145.member_1) {
                phi_282_ = type_9((_e145.member + 1u), _e145.member_1);
                phi_309_ = type_9(1u, _e145.member);
            } else {
                phi_282_ = _e145;
                phi_309_ = type_9(0u, type_9().member_1);
            }
            let _e161 = phi_282_;
            let _e163 = phi_309_;
            if (bitcast<i32>(_e163.member) != 0i) {
                if ((_e147 + 1u) >= _e56) {
                    phi_383_ = u32();
                    phi_384_ = u32();
                    phi_385_ = false;
                } else {
                    let _e171 = slots.member[(_e147 + 1u)];
                    let _e172 = (7u * _e171);
                    let _e175 = contacts.member[(4u + _e172)];
                    let _e178 = params.member.member.member[0u];
                    let _e182 = contacts.member[(_e172 + 6u)];
                    if (((_e175 * _e178) + _e182) != _e72) {
                        phi_380_ = u32();
                        phi_381_ = u32();
                        phi_382_ = false;
                    } else {
                        let _e189 = contacts.member[((7u * _e171) + 7u)];
                        phi_380_ = (_e147 + 1u);
                        phi_381_ = (_e149 + select(0u, 1u, (_e189 < _e76)));
                        phi_382_ = true;
                    }
                    let _e194 = phi_380_;
                    let _e196 = phi_381_;
                    let _e198 = phi_382_;
                    phi_383_ = _e194;
                    phi_384_ = _e196;
                    phi_385_ = _e198;
                }
                let _e200 = phi_383_;
                let _e202 = phi_384_;
                let _e204 = phi_385_;
                phi_285_ = _e200;
                phi_287_ = _e202;
                phi_386_ = _e204;
            } else {
                phi_285_ = u32();
                phi_287_ = u32();
                phi_386_ = false;
            }
            let _e206 = phi_285_;
            let _e208 = phi_287_;
            let _e210 = phi_386_;
            continue;
            continuing {
                phi_281_ = _e161;
                phi_284_ = _e206;
                phi_286_ = _e208;
                break if !(_e210);
            }
        }
        let _e213 = local_1;
        let _e215 = local_2;
        if ((_e213 - _e215) > 4096u) {
            phi_399_ = type_20(_e42, false);
        } else {
            let _e219 = local_3;
            let _e221 = local_4;
            phi_399_ = type_20((_e219 + _e221), true);
        }
        let _e226 = phi_399_;
        if _e226.member_1 {
        } else {
            let _e232 = params.member.member.member[0u];
            let _e235 = params.member.member.member[1u];
            let _e236 = (_e232 + _e235);
            let _e237 = (_e236 / 256u);
            if ((_e236 % 256u) > 0u) {
                phi_426_ = (_e237 + 1u);
            } else {
                phi_426_ = _e237;
            }
            let _e242 = phi_426_;
            let _e246 = atomicOr((&table.member[((256u * _e242) + 256u)]), 1u);
        }
        let _e248 = slots.member[_e42];
        local = (4u + (7u * _e248));
        let _e251 = local;
        let _e253 = contacts.member[_e251];
        let _e254 = local;
        let _e257 = contacts.member[(_e254 + 1u)];
        let _e258 = local;
        let _e261 = contacts.member[(_e258 + 2u)];
        let _e262 = local;
        let _e265 = contacts.member[(_e262 + 3u)];
        let _e266 = local;
        let _e269 = contacts.member[(_e266 + 4u)];
        let _e270 = local;
        let _e273 = contacts.member[(_e270 + 5u)];
        let _e274 = local;
        let _e277 = contacts.member[(_e274 + 6u)];
        ordered.member[_e226.member] = vec4<u32>((_e261 | (_e253 << bitcast<u32>(31i))), (_e265 | (_e257 << bitcast<u32>(31i))), _e269, ((_e273 & 1073741823u) | (_e277 << bitcast<u32>(30i))));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
