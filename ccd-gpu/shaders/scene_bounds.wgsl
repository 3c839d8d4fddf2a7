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

struct type_12 {
    member: i32,
    member_1: i32,
}

struct type_13 {
    member: u32,
    member_1: i32,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_24 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> boxes: type_17;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage, read_write> words: type_24;
var<workgroup> shared_: array<type_15, 256>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_15;
    var phi_101_: type_9;
    var phi_104_: type_15;
    var phi_102_: type_9;
    var phi_127_: type_9;
    var phi_157_: f32;
    var phi_164_: f32;
    var phi_171_: f32;
    var phi_179_: f32;
    var phi_186_: f32;
    var phi_193_: f32;
    var phi_196_: type_15;
    var phi_105_: type_15;
    var local_1: type_15;
    var local_2: type_15;
    var local_3: type_15;
    var local_4: type_15;
    var phi_234_: type_12;
    var phi_237_: u32;
    var phi_258_: bool;
    var phi_264_: type_13;
    var phi_235_: type_12;
    var phi_278_: type_13;
    var phi_310_: f32;
    var phi_318_: f32;
    var phi_326_: f32;
    var phi_336_: f32;
    var phi_345_: f32;
    var phi_354_: f32;
    var phi_238_: u32;
    var phi_399_: type_9;
    var phi_400_: type_9;
    var phi_423_: type_9;
    var phi_469_: u32;
    var phi_450_: u32;
    var phi_470_: u32;
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
    phi_101_ = type_9(0u, 8u);
    phi_104_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
    loop {
        let _e46 = phi_101_;
        let _e48 = phi_104_;
        local_1 = _e48;
        local_2 = _e48;
        local_3 = _e48;
        local_4 = _e48;
        if (_e46.member < _e46.member_1) {
            phi_102_ = type_9((_e46.member + 1u), _e46.member_1);
            phi_127_ = type_9(1u, _e46.member);
        } else {
            phi_102_ = _e46;
            phi_127_ = type_9(0u, type_9().member_1);
        }
        let _e60 = phi_102_;
        let _e62 = phi_127_;
        let _e66 = (bitcast<i32>(_e62.member) != 0i);
        if _e66 {
            let _e68 = (((((_e29.y * _e30.x) + _e29.x) * 2048u) + _e31) + (_e62.member_1 * 256u));
            if (_e68 < _e44) {
                let _e71 = boxes.member[_e68];
                if (_e48.member[0] < _e71.member[0]) {
                    phi_157_ = _e48.member[0];
                } else {
                    phi_157_ = _e71.member[0];
                }
                let _e78 = phi_157_;
                if (_e48.member[1] < _e71.member[1]) {
                    phi_164_ = _e48.member[1];
                } else {
                    phi_164_ = _e71.member[1];
                }
                let _e85 = phi_164_;
                if (_e48.member[2] < _e71.member[2]) {
                    phi_171_ = _e48.member[2];
                } else {
                    phi_171_ = _e71.member[2];
                }
                let _e92 = phi_171_;
                if (_e48.member_1[0] > _e71.member_1[0]) {
                    phi_179_ = _e48.member_1[0];
                } else {
                    phi_179_ = _e71.member_1[0];
                }
                let _e100 = phi_179_;
                if (_e48.member_1[1] > _e71.member_1[1]) {
                    phi_186_ = _e48.member_1[1];
                } else {
                    phi_186_ = _e71.member_1[1];
                }
                let _e107 = phi_186_;
                if (_e48.member_1[2] > _e71.member_1[2]) {
                    phi_193_ = _e48.member_1[2];
                } else {
                    phi_193_ = _e71.member_1[2];
                }
                let _e114 = phi_193_;
                phi_196_ = type_15(array<f32, 3>(_e78, _e85, _e92), array<f32, 3>(_e100, _e107, _e114));
            } else {
                phi_196_ = _e48;
            }
            let _e118 = phi_196_;
            phi_105_ = _e118;
        } else {
            phi_105_ = type_15();
        }
        let _e120 = phi_105_;
        continue;
        continuing {
            phi_101_ = _e60;
            phi_104_ = _e120;
            break if !(_e66);
        }
    }
    let _e123 = local_1;
    let _e130 = local_2;
    local = type_15(array<f32, 3>(_e123.member[0], _e123.member[1], _e123.member[2]), array<f32, 3>(_e130.member_1[0], _e130.member_1[1], _e130.member_1[2]));
    let _e139 = local_3;
    let _e146 = local_4;
    shared_[_e31] = type_15(array<f32, 3>(_e139.member[0], _e139.member[1], _e139.member[2]), array<f32, 3>(_e146.member_1[0], _e146.member_1[1], _e146.member_1[2]));
    phi_234_ = type_12(0i, 8i);
    phi_237_ = 128u;
    loop {
        let _e154 = phi_234_;
        let _e156 = phi_237_;
        if (_e154.member < _e154.member_1) {
            let _e163 = (_e154.member + 1i);
            if ((false == (_e163 > _e154.member)) != false) {
                phi_258_ = true;
            } else {
                phi_258_ = false;
            }
            let _e168 = phi_258_;
            if _e168 {
                phi_264_ = type_13(0u, type_13().member_1);
            } else {
                phi_264_ = type_13(1u, _e163);
            }
            let _e173 = phi_264_;
            phi_235_ = type_12(_e173.member_1, _e154.member_1);
            phi_278_ = type_13(1u, _e154.member);
        } else {
            phi_235_ = _e154;
            phi_278_ = type_13(0u, type_13().member_1);
        }
        let _e179 = phi_235_;
        let _e181 = phi_278_;
        let _e184 = (bitcast<i32>(_e181.member) != 0i);
        if _e184 {
            workgroupBarrier();
            if (_e31 < _e156) {
                let _e188 = shared_[(_e31 + _e156)];
                let _e199 = local.member[0u];
                if (_e199 < _e188.member[0]) {
                    phi_310_ = _e199;
                } else {
                    phi_310_ = _e188.member[0];
                }
                let _e202 = phi_310_;
                let _e205 = local.member[1u];
                if (_e205 < _e188.member[1]) {
                    phi_318_ = _e205;
                } else {
                    phi_318_ = _e188.member[1];
                }
                let _e208 = phi_318_;
                let _e211 = local.member[2u];
                if (_e211 < _e188.member[2]) {
                    phi_326_ = _e211;
                } else {
                    phi_326_ = _e188.member[2];
                }
                let _e214 = phi_326_;
                let _e217 = local.member_1[0u];
                if (_e217 > _e188.member_1[0]) {
                    phi_336_ = _e217;
                } else {
                    phi_336_ = _e188.member_1[0];
                }
                let _e220 = phi_336_;
                let _e223 = local.member_1[1u];
                if (_e223 > _e188.member_1[1]) {
                    phi_345_ = _e223;
                } else {
                    phi_345_ = _e188.member_1[1];
                }
                let _e226 = phi_345_;
                let _e229 = local.member_1[2u];
                if (_e229 > _e188.member_1[2]) {
                    phi_354_ = _e229;
                } else {
                    phi_354_ = _e188.member_1[2];
                }
                let _e232 = phi_354_;
                local = type_15(array<f32, 3>(_e202, _e208, _e214), array<f32, 3>(_e220, _e226, _e232));
                shared_[_e31] = type_15(array<f32, 3>(_e202, _e208, _e214), array<f32, 3>(_e220, _e226, _e232));
            }
            phi_238_ = (_e156 / 2u);
        } else {
            phi_238_ = u32();
        }
        let _e242 = phi_238_;
        continue;
        continuing {
            phi_234_ = _e179;
            phi_237_ = _e242;
            break if !(_e184);
        }
    }
    if (_e31 == 0u) {
        phi_399_ = type_9(0u, 6u);
        loop {
            let _e246 = phi_399_;
            if (_e246.member < _e246.member_1) {
                phi_400_ = type_9((_e246.member + 1u), _e246.member_1);
                phi_423_ = type_9(1u, _e246.member);
            } else {
                phi_400_ = _e246;
                phi_423_ = type_9(0u, type_9().member_1);
            }
            let _e258 = phi_400_;
            let _e260 = phi_423_;
            let _e264 = (bitcast<i32>(_e260.member) != 0i);
            if _e264 {
                if (_e260.member_1 < 3u) {
                    let _e280 = local.member[_e260.member_1];
                    let _e281 = bitcast<u32>(_e280);
                    if ((_e281 >> bitcast<u32>(31i)) == 1u) {
                        phi_450_ = ~(_e281);
                    } else {
                        phi_450_ = (_e281 | 2147483648u);
                    }
                    let _e288 = phi_450_;
                    phi_470_ = ~(_e288);
                } else {
                    let _e269 = local.member_1[(_e260.member_1 - 3u)];
                    let _e270 = bitcast<u32>(_e269);
                    if ((_e270 >> bitcast<u32>(31i)) == 1u) {
                        phi_469_ = ~(_e270);
                    } else {
                        phi_469_ = (_e270 | 2147483648u);
                    }
                    let _e277 = phi_469_;
                    phi_470_ = _e277;
                }
                let _e291 = phi_470_;
                let _e293 = atomicMax((&words.member[_e260.member_1]), _e291);
            }
            continue;
            continuing {
                phi_399_ = _e258;
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
