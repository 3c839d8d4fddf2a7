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

struct type_22 {
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
var<storage, read_write> table: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_170_: type_9;
    var phi_173_: u32;
    var phi_175_: u32;
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
    var phi_380_: u32;
    var phi_381_: u32;
    var phi_382_: bool;
    var phi_383_: u32;
    var phi_384_: u32;
    var phi_385_: bool;
    var phi_285_: u32;
    var phi_287_: u32;
    var phi_386_: bool;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e27 = id_2;
    let _e28 = n_2;
    let _e29 = lane_2;
    let _e41 = ((((_e27.y * _e28.x) + _e27.x) * 256u) + _e29);
    let _e44 = params.member.member_1.member;
    let _e47 = params.member.member_1.member_2;
    let _e49 = contacts.member[0u];
    let _e51 = select(_e49, _e47, (_e47 < _e49));
    let _e53 = select(_e44, _e51, (_e51 < _e44));
    if (_e41 < _e53) {
        let _e57 = slots.member[_e41];
        let _e58 = (7u * _e57);
        let _e61 = contacts.member[(4u + _e58)];
        let _e64 = params.member.member.member[0u];
        let _e68 = contacts.member[(_e58 + 6u)];
        let _e69 = ((_e61 * _e64) + _e68);
        let _e73 = contacts.member[((7u * _e57) + 7u)];
        phi_170_ = type_9(0u, 4097u);
        phi_173_ = 0u;
        phi_175_ = _e41;
        loop {
            let _e75 = phi_170_;
            let _e77 = phi_173_;
            let _e79 = phi_175_;
            local_4 = _e77;
            local_1 = _e79;
            local_2 = _e79;
            let _e82 = (_e75.member < _e75.member_1);
            if (bitcast<i32>(select(0u, 1u, _e82)) != 0i) {
                if (_e79 == 0u) {
                    phi_271_ = u32();
                    phi_272_ = u32();
                    phi_273_ = false;
                } else {
                    let _e97 = slots.member[(_e79 - 1u)];
                    let _e98 = (7u * _e97);
                    let _e101 = contacts.member[(4u + _e98)];
                    let _e104 = params.member.member.member[0u];
                    let _e108 = contacts.member[(_e98 + 6u)];
                    if (((_e101 * _e104) + _e108) != _e69) {
                        phi_268_ = u32();
                        phi_269_ = u32();
                        phi_270_ = false;
                    } else {
                        let _e115 = contacts.member[((7u * _e97) + 7u)];
                        phi_268_ = (_e77 + select(0u, 1u, (_e115 <= _e73)));
                        phi_269_ = (_e79 - 1u);
                        phi_270_ = true;
                    }
                    let _e120 = phi_268_;
                    let _e122 = phi_269_;
                    let _e124 = phi_270_;
                    phi_271_ = _e120;
                    phi_272_ = _e122;
                    phi_273_ = _e124;
                }
                let _e126 = phi_271_;
                let _e128 = phi_272_;
                let _e130 = phi_273_;
                phi_174_ = _e126;
                phi_176_ = _e128;
                phi_274_ = _e130;
            } else {
                phi_174_ = u32();
                phi_176_ = u32();
                phi_274_ = false;
            }
            let _e132 = phi_174_;
            let _e134 = phi_176_;
            let _e136 = phi_274_;
            continue;
            continuing {
                phi_170_ = type_9(select(_e75.member, (_e75.member + 1u), _e82), select(_e75.member_1, _e75.member_1, _e82));
                phi_173_ = _e132;
                phi_175_ = _e134;
                break if !(_e136);
            }
        }
        phi_281_ = type_9(0u, 4097u);
        phi_284_ = _e41;
        let _e285 = local_4;
        phi_286_ = _e285;
        loop {
            let _e139 = phi_281_;
            let _e141 = phi_284_;
            let _e143 = phi_286_;
            local = _e141;
            local_3 = _e143;
            let _e146 = (_e139.member < _e139.member_1);
            if (bitcast<i32>(select(0u, 1u, _e146)) != 0i) {
                if ((_e141 + 1u) >= _e53) {
                    phi_383_ = u32();
                    phi_384_ = u32();
                    phi_385_ = false;
                } else {
                    let _e162 = slots.member[(_e141 + 1u)];
                    let _e163 = (7u * _e162);
                    let _e166 = contacts.member[(4u + _e163)];
                    let _e169 = params.member.member.member[0u];
                    let _e173 = contacts.member[(_e163 + 6u)];
                    if (((_e166 * _e169) + _e173) != _e69) {
                        phi_380_ = u32();
                        phi_381_ = u32();
                        phi_382_ = false;
                    } else {
                        let _e180 = contacts.member[((7u * _e162) + 7u)];
                        phi_380_ = (_e141 + 1u);
                        phi_381_ = (_e143 + select(0u, 1u, (_e180 < _e73)));
                        phi_382_ = true;
                    }
                    let _e185 = phi_380_;
                    let _e187 = phi_381_;
                    let _e189 = phi_382_;
                    phi_383_ = _e185;
                    phi_384_ = _e187;
                    phi_385_ = _e189;
                }
                let _e191 = phi_383_;
                let _e193 = phi_384_;
                let _e195 = phi_385_;
                phi_285_ = _e191;
                phi_287_ = _e193;
                phi_386_ = _e195;
            } else {
                phi_285_ = u32();
                phi_287_ = u32();
                phi_386_ = false;
            }
            let _e197 = phi_285_;
            let _e199 = phi_287_;
            let _e201 = phi_386_;
            continue;
            continuing {
                phi_281_ = type_9(select(_e139.member, (_e139.member + 1u), _e146), select(_e139.member_1, _e139.member_1, _e146));
                phi_284_ = _e197;
                phi_286_ = _e199;
                break if !(_e201);
            }
        }
        let _e204 = local;
        let _e206 = local_1;
        let _e208 = ((_e204 - _e206) > 4096u);
        let _e210 = local_2;
        let _e212 = local_3;
        if select(true, false, _e208) {
        } else {
            let _e219 = params.member.member.member[0u];
            let _e222 = params.member.member.member[1u];
            let _e223 = (_e219 + _e222);
            let _e224 = (_e223 / 256u);
            let _e232 = atomicOr((&table.member[((256u * select(_e224, (_e224 + 1u), ((_e223 % 256u) > 0u))) + 256u)]), 1u);
        }
        let _e234 = slots.member[_e41];
        let _e235 = (7u * _e234);
        let _e238 = contacts.member[(4u + _e235)];
        let _e241 = contacts.member[(_e235 + 5u)];
        let _e244 = contacts.member[(_e235 + 6u)];
        let _e247 = contacts.member[(_e235 + 7u)];
        let _e250 = contacts.member[(_e235 + 8u)];
        let _e253 = contacts.member[(_e235 + 9u)];
        let _e256 = contacts.member[(_e235 + 10u)];
        ordered.member[select((_e210 + _e212), _e41, _e208)] = vec4<u32>((_e244 | (_e238 << bitcast<u32>(31i))), (_e247 | (_e241 << bitcast<u32>(31i))), _e250, ((_e253 & 1073741823u) | (_e256 << bitcast<u32>(30i))));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn order_contacts(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
