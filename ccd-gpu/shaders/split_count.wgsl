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

struct type_13 {
    member: u32,
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

var<workgroup> counts: array<atomic<u32>, 256>;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> levels: type_11;
@group(0) @binding(2) 
var<storage> present: type_11;
@group(0) @binding(3) 
var<storage, read_write> table: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: array<u32, 3>;
    var phi_153_: u32;
    var phi_154_: u32;
    var phi_175_: u32;
    var phi_176_: u32;
    var phi_193_: type_9;
    var phi_196_: u32;
    var phi_194_: type_9;
    var phi_219_: type_9;
    var phi_241_: u32;
    var phi_242_: u32;
    var phi_197_: u32;
    var phi_259_: type_9;
    var phi_262_: u32;
    var phi_260_: type_9;
    var phi_285_: type_9;
    var phi_307_: u32;
    var phi_308_: u32;
    var phi_263_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_320_: array<u32, 2>;
    var phi_326_: type_9;
    var phi_327_: type_9;
    var phi_350_: type_9;
    var phi_375_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e22 = id_2;
    let _e23 = n_2;
    let _e24 = lane_2;
    let _e33 = ((_e22.y * _e23.x) + _e22.x);
    let _e36 = params.member.member_2.member;
    let _e40 = params.member.member.member[_e36];
    let _e41 = (_e40 - 1u);
    atomicStore((&counts[_e24]), 0u);
    workgroupBarrier();
    let _e44 = ((_e33 * 256u) + _e24);
    if (_e44 < _e41) {
        let _e47 = present.member[0u];
        let _e49 = present.member[1u];
        let _e51 = present.member[2u];
        let _e53 = levels.member[_e44];
        if (_e44 > 0u) {
            let _e57 = levels.member[(_e44 - 1u)];
            if (_e57 < _e53) {
                phi_153_ = _e53;
            } else {
                phi_153_ = _e57;
            }
            let _e60 = phi_153_;
            phi_154_ = _e60;
        } else {
            phi_154_ = _e53;
        }
        let _e62 = phi_154_;
        if ((_e44 + 1u) < _e41) {
            let _e67 = levels.member[(_e44 + 1u)];
            if (_e67 < _e62) {
                phi_175_ = _e62;
            } else {
                phi_175_ = _e67;
            }
            let _e70 = phi_175_;
            phi_176_ = _e70;
        } else {
            phi_176_ = _e62;
        }
        let _e72 = phi_176_;
        let _e74 = levels.member[_e44];
        local_1 = array<u32, 3>(_e47, _e49, _e51);
        phi_193_ = type_9(0u, 3u);
        phi_196_ = 0u;
        loop {
            let _e77 = phi_193_;
            let _e79 = phi_196_;
            local_2 = _e79;
            if (_e77.member < _e77.member_1) {
                phi_194_ = type_9((_e77.member + 1u), _e77.member_1);
                phi_219_ = type_9(1u, _e77.member);
            } else {
                phi_194_ = _e77;
                phi_219_ = type_9(0u, type_9().member_1);
            }
            let _e91 = phi_194_;
            let _e93 = phi_219_;
            let _e97 = (bitcast<i32>(_e93.member) != 0i);
            if _e97 {
                let _e98 = (32u * _e93.member_1);
                if (_e74 >= (_e98 + 32u)) {
                    phi_242_ = 4294967295u;
                } else {
                    if (_e74 > _e98) {
                        phi_241_ = ((1u << bitcast<u32>(((_e74 - _e98) & 31u))) - 1u);
                    } else {
                        phi_241_ = 0u;
                    }
                    let _e108 = phi_241_;
                    phi_242_ = _e108;
                }
                let _e110 = phi_242_;
                let _e112 = local_1[_e93.member_1];
                phi_197_ = (_e79 + countOneBits((_e112 & _e110)));
            } else {
                phi_197_ = u32();
            }
            let _e117 = phi_197_;
            continue;
            continuing {
                phi_193_ = _e91;
                phi_196_ = _e117;
                break if !(_e97);
            }
        }
        local = array<u32, 3>(_e47, _e49, _e51);
        phi_259_ = type_9(0u, 3u);
        phi_262_ = 0u;
        loop {
            let _e121 = phi_259_;
            let _e123 = phi_262_;
            local_3 = _e123;
            if (_e121.member < _e121.member_1) {
                phi_260_ = type_9((_e121.member + 1u), _e121.member_1);
                phi_285_ = type_9(1u, _e121.member);
            } else {
                phi_260_ = _e121;
                phi_285_ = type_9(0u, type_9().member_1);
            }
            let _e135 = phi_260_;
            let _e137 = phi_285_;
            let _e141 = (bitcast<i32>(_e137.member) != 0i);
            if _e141 {
                let _e142 = (32u * _e137.member_1);
                if (_e72 >= (_e142 + 32u)) {
                    phi_308_ = 4294967295u;
                } else {
                    if (_e72 > _e142) {
                        phi_307_ = ((1u << bitcast<u32>(((_e72 - _e142) & 31u))) - 1u);
                    } else {
                        phi_307_ = 0u;
                    }
                    let _e152 = phi_307_;
                    phi_308_ = _e152;
                }
                let _e154 = phi_308_;
                let _e156 = local[_e137.member_1];
                phi_263_ = (_e123 + countOneBits((_e156 & _e154)));
            } else {
                phi_263_ = u32();
            }
            let _e161 = phi_263_;
            continue;
            continuing {
                phi_259_ = _e135;
                phi_262_ = _e161;
                break if !(_e141);
            }
        }
        let _e164 = local_2;
        let _e166 = local_3;
        phi_320_ = array<u32, 2>(_e164, _e166);
    } else {
        phi_320_ = array<u32, 2>(1u, 0u);
    }
    let _e169 = phi_320_;
    phi_326_ = type_9(_e169[0], (_e169[1] + 1u));
    loop {
        let _e175 = phi_326_;
        if (_e175.member < _e175.member_1) {
            phi_327_ = type_9((_e175.member + 1u), _e175.member_1);
            phi_350_ = type_9(1u, _e175.member);
        } else {
            phi_327_ = _e175;
            phi_350_ = type_9(0u, type_9().member_1);
        }
        let _e187 = phi_327_;
        let _e189 = phi_350_;
        let _e193 = (bitcast<i32>(_e189.member) != 0i);
        if _e193 {
            let _e195 = atomicAdd((&counts[_e189.member_1]), 1u);
        }
        continue;
        continuing {
            phi_326_ = _e187;
            break if !(_e193);
        }
    }
    workgroupBarrier();
    let _e197 = (_e41 / 256u);
    if ((_e41 % 256u) > 0u) {
        phi_375_ = (_e197 + 1u);
    } else {
        phi_375_ = _e197;
    }
    let _e202 = phi_375_;
    if (_e33 < _e202) {
        let _e207 = atomicLoad((&counts[_e24]));
        table.member[((_e24 * _e202) + _e33)] = _e207;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn split_count(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
