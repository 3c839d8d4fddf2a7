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

struct type_13 {
    member: array<vec4<u32>>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_15 {
    member: type_6,
    member_1: type_7,
    member_2: type_14,
}

struct type_16 {
    member: type_15,
}

struct type_17 {
    member: f32,
    member_1: u32,
}

@group(0) @binding(0) 
var<storage> params: type_16;
@group(0) @binding(1) 
var<storage, read_write> items: type_13;
var<workgroup> shared_: array<vec4<u32>, 4>;
var<workgroup> found: array<atomic<u32>, 2>;

fn function_(lane_1: u32) {
    var phi_75_: type_8;
    var phi_173_: type_8;
    var phi_176_: type_17;
    var phi_255_: type_17;
    var phi_256_: bool;
    var phi_177_: type_17;
    var phi_265_: type_17;
    var local: type_17;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e17 = lane_2;
    let _e22 = params.member.member_1.member;
    let _e25 = params.member.member_2.member_2;
    phi_75_ = type_8(0u, _e25);
    loop {
        let _e28 = phi_75_;
        let _e31 = (_e28.member < _e28.member_1);
        let _e44 = (bitcast<i32>(select(0u, 1u, _e31)) != 0i);
        if _e44 {
            let _e47 = params.member.member_1.member_1;
            let _e49 = (_e47 + (2u * select(type_8().member_1, _e28.member, _e31)));
            let _e50 = (_e49 + 1u);
            if (_e17 == (_e49 % 256u)) {
                let _e54 = items.member[_e49];
                shared_[0u] = _e54;
            }
            if (_e17 == 0u) {
                atomicStore((&found[0u]), 2137108966u);
                atomicStore((&found[1u]), 4294967295u);
            }
            workgroupBarrier();
            let _e60 = shared_[0u];
            let _e67 = type_17(300000000000000000000000000000000000000f, _e50);
            let _e72 = (_e50 + (((_e17 + 256u) - (_e50 % 256u)) % 256u));
            if (_e72 < _e22) {
                let _e74 = (_e22 - _e72);
                let _e75 = (_e74 / 256u);
                phi_173_ = type_8(0u, select(_e75, (_e75 + 1u), ((_e74 % 256u) > 0u)));
                phi_176_ = _e67;
                loop {
                    let _e82 = phi_173_;
                    let _e84 = phi_176_;
                    local = _e84;
                    let _e87 = (_e82.member < _e82.member_1);
                    let _e100 = (bitcast<i32>(select(0u, 1u, _e87)) != 0i);
                    if _e100 {
                        let _e102 = (_e72 + (select(type_8().member_1, _e82.member, _e87) * 256u));
                        let _e104 = items.member[_e102];
                        let _e111 = (bitcast<f32>(_e60.x) - bitcast<f32>(_e104.x));
                        let _e112 = (bitcast<f32>(_e60.y) - bitcast<f32>(_e104.y));
                        let _e113 = (bitcast<f32>(_e60.z) - bitcast<f32>(_e104.z));
                        let _e118 = (((_e111 * _e111) + (_e112 * _e112)) + (_e113 * _e113));
                        if (_e118 < _e84.member) {
                            phi_255_ = type_17();
                            phi_256_ = true;
                        } else {
                            let _e125 = select(true, select(true, false, (_e102 < _e84.member_1)), (_e118 == _e84.member));
                            phi_255_ = type_17(select(type_17().member, _e84.member, _e125), select(type_17().member_1, _e84.member_1, _e125));
                            phi_256_ = select(true, false, _e125);
                        }
                        let _e135 = phi_255_;
                        let _e137 = phi_256_;
                        phi_177_ = type_17(select(_e135.member, _e118, _e137), select(_e135.member_1, _e102, _e137));
                    } else {
                        phi_177_ = type_17();
                    }
                    let _e144 = phi_177_;
                    continue;
                    continuing {
                        phi_173_ = type_8(select(_e82.member, (_e82.member + 1u), _e87), select(_e82.member_1, _e82.member_1, _e87));
                        phi_176_ = _e144;
                        break if !(_e100);
                    }
                }
                let _e188 = local;
                phi_265_ = _e188;
            } else {
                phi_265_ = _e67;
            }
            let _e147 = phi_265_;
            let _e151 = atomicMin((&found[0u]), bitcast<u32>(_e147.member));
            workgroupBarrier();
            let _e155 = atomicLoad((&found[0u]));
            if (bitcast<u32>(_e147.member) == _e155) {
                let _e159 = atomicMin((&found[1u]), _e147.member_1);
            }
            workgroupBarrier();
            let _e161 = atomicLoad((&found[1u]));
            let _e163 = (_e17 == (_e50 % 256u));
            let _e165 = (_e17 == (_e161 % 256u));
            if _e163 {
                let _e167 = items.member[_e50];
                shared_[1u] = _e167;
            }
            if _e165 {
                let _e170 = items.member[_e161];
                shared_[2u] = _e170;
            }
            workgroupBarrier();
            if _e163 {
                let _e173 = shared_[2u];
                items.member[_e50] = _e173;
            }
            if _e165 {
                if (_e161 != _e50) {
                    let _e177 = shared_[1u];
                    items.member[_e161] = _e177;
                }
            }
        }
        continue;
        continuing {
            phi_75_ = type_8(select(_e28.member, (_e28.member + 1u), _e31), select(_e28.member_1, _e28.member_1, _e31));
            break if !(_e44);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn pair_nearest(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
