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

struct type_12 {
    member: i32,
    member_1: i32,
}

struct type_13 {
    member: u32,
    member_1: i32,
}

struct type_15 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_20 {
    member: u32,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_26 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(2) 
var<storage, read_write> words: type_26;
var<workgroup> shared_: array<type_19, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var phi_103_: type_9;
    var phi_106_: type_19;
    var phi_104_: type_9;
    var phi_129_: type_9;
    var phi_164_: f32;
    var phi_170_: f32;
    var phi_176_: f32;
    var phi_183_: f32;
    var phi_189_: f32;
    var phi_195_: f32;
    var phi_198_: type_19;
    var phi_107_: type_19;
    var local_1: type_19;
    var local_2: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var phi_236_: type_12;
    var phi_239_: u32;
    var phi_260_: bool;
    var phi_266_: type_13;
    var phi_237_: type_12;
    var phi_280_: type_13;
    var phi_312_: f32;
    var phi_320_: f32;
    var phi_328_: f32;
    var phi_338_: f32;
    var phi_347_: f32;
    var phi_356_: f32;
    var phi_240_: u32;
    var phi_401_: type_9;
    var phi_402_: type_9;
    var phi_425_: type_9;
    var phi_471_: u32;
    var phi_452_: u32;
    var phi_472_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e44 = params.member.member_1.member;
    phi_103_ = type_9(0u, 8u);
    phi_106_ = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    loop {
        let _e46 = phi_103_;
        let _e48 = phi_106_;
        local_1 = _e48;
        local_2 = _e48;
        local_3 = _e48;
        local_4 = _e48;
        if (_e46.member < _e46.member_1) {
            phi_104_ = type_9((_e46.member + 1u), _e46.member_1);
            phi_129_ = type_9(1u, _e46.member);
        } else {
            phi_104_ = _e46;
            phi_129_ = type_9(0u, type_9().member_1);
        }
        let _e60 = phi_104_;
        let _e62 = phi_129_;
        let _e66 = (bitcast<i32>(_e62.member) != 0i);
        if _e66 {
            let _e68 = (((((_e29.y * _e30.x) + _e29.x) * 2048u) + _e31) + (_e62.member_1 * 256u));
            if (_e68 < _e44) {
                let _e71 = boxes.member[_e68];
                if (_e48.member[0] < _e71.member.x) {
                    phi_164_ = _e48.member[0];
                } else {
                    phi_164_ = _e71.member.x;
                }
                let _e88 = phi_164_;
                if (_e48.member[1] < _e71.member.y) {
                    phi_170_ = _e48.member[1];
                } else {
                    phi_170_ = _e71.member.y;
                }
                let _e93 = phi_170_;
                if (_e48.member[2] < _e71.member_1.x) {
                    phi_176_ = _e48.member[2];
                } else {
                    phi_176_ = _e71.member_1.x;
                }
                let _e98 = phi_176_;
                if (_e48.member_1[0] > _e71.member_1.y) {
                    phi_183_ = _e48.member_1[0];
                } else {
                    phi_183_ = _e71.member_1.y;
                }
                let _e104 = phi_183_;
                if (_e48.member_1[1] > _e71.member_2.x) {
                    phi_189_ = _e48.member_1[1];
                } else {
                    phi_189_ = _e71.member_2.x;
                }
                let _e109 = phi_189_;
                if (_e48.member_1[2] > _e71.member_2.y) {
                    phi_195_ = _e48.member_1[2];
                } else {
                    phi_195_ = _e71.member_2.y;
                }
                let _e114 = phi_195_;
                phi_198_ = type_19(array<f32, 3>(_e88, _e93, _e98), array<f32, 3>(_e104, _e109, _e114));
            } else {
                phi_198_ = _e48;
            }
            let _e118 = phi_198_;
            phi_107_ = _e118;
        } else {
            phi_107_ = type_19();
        }
        let _e120 = phi_107_;
        continue;
        continuing {
            phi_103_ = _e60;
            phi_106_ = _e120;
            break if !(_e66);
        }
    }
    let _e123 = local_1;
    let _e130 = local_2;
    local = type_19(array<f32, 3>(_e123.member[0], _e123.member[1], _e123.member[2]), array<f32, 3>(_e130.member_1[0], _e130.member_1[1], _e130.member_1[2]));
    let _e139 = local_3;
    let _e146 = local_4;
    shared_[_e31] = type_19(array<f32, 3>(_e139.member[0], _e139.member[1], _e139.member[2]), array<f32, 3>(_e146.member_1[0], _e146.member_1[1], _e146.member_1[2]));
    phi_236_ = type_12(0i, 8i);
    phi_239_ = 128u;
    loop {
        let _e154 = phi_236_;
        let _e156 = phi_239_;
        if (_e154.member < _e154.member_1) {
            let _e163 = (_e154.member + 1i);
            if ((false == (_e163 > _e154.member)) != false) {
                phi_260_ = true;
            } else {
                phi_260_ = false;
            }
            let _e168 = phi_260_;
            if _e168 {
                phi_266_ = type_13(0u, type_13().member_1);
            } else {
                phi_266_ = type_13(1u, _e163);
            }
            let _e173 = phi_266_;
            phi_237_ = type_12(_e173.member_1, _e154.member_1);
            phi_280_ = type_13(1u, _e154.member);
        } else {
            phi_237_ = _e154;
            phi_280_ = type_13(0u, type_13().member_1);
        }
        let _e179 = phi_237_;
        let _e181 = phi_280_;
        let _e184 = (bitcast<i32>(_e181.member) != 0i);
        if _e184 {
            workgroupBarrier();
            if (_e31 < _e156) {
                let _e188 = shared_[(_e31 + _e156)];
                let _e199 = local.member[0u];
                if (_e199 < _e188.member[0]) {
                    phi_312_ = _e199;
                } else {
                    phi_312_ = _e188.member[0];
                }
                let _e202 = phi_312_;
                let _e205 = local.member[1u];
                if (_e205 < _e188.member[1]) {
                    phi_320_ = _e205;
                } else {
                    phi_320_ = _e188.member[1];
                }
                let _e208 = phi_320_;
                let _e211 = local.member[2u];
                if (_e211 < _e188.member[2]) {
                    phi_328_ = _e211;
                } else {
                    phi_328_ = _e188.member[2];
                }
                let _e214 = phi_328_;
                let _e217 = local.member_1[0u];
                if (_e217 > _e188.member_1[0]) {
                    phi_338_ = _e217;
                } else {
                    phi_338_ = _e188.member_1[0];
                }
                let _e220 = phi_338_;
                let _e223 = local.member_1[1u];
                if (_e223 > _e188.member_1[1]) {
                    phi_347_ = _e223;
                } else {
                    phi_347_ = _e188.member_1[1];
                }
                let _e226 = phi_347_;
                let _e229 = local.member_1[2u];
                if (_e229 > _e188.member_1[2]) {
                    phi_356_ = _e229;
                } else {
                    phi_356_ = _e188.member_1[2];
                }
                let _e232 = phi_356_;
                local = type_19(array<f32, 3>(_e202, _e208, _e214), array<f32, 3>(_e220, _e226, _e232));
                shared_[_e31] = type_19(array<f32, 3>(_e202, _e208, _e214), array<f32, 3>(_e220, _e226, _e232));
            }
            phi_240_ = (_e156 / 2u);
        } else {
            phi_240_ = u32();
        }
        let _e242 = phi_240_;
        continue;
        continuing {
            phi_236_ = _e179;
            phi_239_ = _e242;
            break if !(_e184);
        }
    }
    if (_e31 == 0u) {
        phi_401_ = type_9(0u, 6u);
        loop {
            let _e246 = phi_401_;
            if (_e246.member < _e246.member_1) {
                phi_402_ = type_9((_e246.member + 1u), _e246.member_1);
                phi_425_ = type_9(1u, _e246.member);
            } else {
                phi_402_ = _e246;
                phi_425_ = type_9(0u, type_9().member_1);
            }
            let _e258 = phi_402_;
            let _e260 = phi_425_;
            let _e264 = (bitcast<i32>(_e260.member) != 0i);
            if _e264 {
                if (_e260.member_1 < 3u) {
                    let _e280 = local.member[_e260.member_1];
                    let _e281 = bitcast<u32>(_e280);
                    if ((_e281 >> bitcast<u32>(31i)) == 1u) {
                        phi_452_ = ~(_e281);
                    } else {
                        phi_452_ = (_e281 | 2147483648u);
                    }
                    let _e288 = phi_452_;
                    phi_472_ = ~(_e288);
                } else {
                    let _e269 = local.member_1[(_e260.member_1 - 3u)];
                    let _e270 = bitcast<u32>(_e269);
                    if ((_e270 >> bitcast<u32>(31i)) == 1u) {
                        phi_471_ = ~(_e270);
                    } else {
                        phi_471_ = (_e270 | 2147483648u);
                    }
                    let _e277 = phi_471_;
                    phi_472_ = _e277;
                }
                let _e291 = phi_472_;
                let _e293 = atomicMax((&words.member[_e260.member_1]), _e291);
            }
            continue;
            continuing {
                phi_401_ = _e258;
                break if !(_e264);
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn scene_bounds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
