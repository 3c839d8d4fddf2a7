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

struct type_10 {
    member: array<u32>,
}

struct type_13 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_14 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_6,
    member_1: type_7,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: array<type_13>,
}

struct type_22 {
    member: array<type_14>,
}

struct type_23 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<type_8>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> paths: type_20;
@group(0) @binding(2) 
var<storage> leaves: type_22;
@group(0) @binding(3) 
var<storage> touches: type_25;
@group(0) @binding(4) 
var<storage> pairs: type_27;
@group(0) @binding(5) 
var<storage, read_write> words: type_10;

fn function_(lane_1: u32) {
    var local: type_13;
    var local_1: type_14;
    var phi_141_: type_8;
    var phi_188_: type_8;
    var phi_263_: type_8;
    var phi_358_: type_8;
    var phi_441_: type_8;
    var phi_475_: type_8;
    var phi_606_: type_8;
    var phi_665_: type_8;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e60 = lane_2;
    if (_e60 == 0u) {
        phi_141_ = type_8(0u, 3u);
        loop {
            let _e71 = phi_141_;
            let _e74 = (_e71.member < _e71.member_1);
            let _e85 = select(type_8().member_1, _e71.member, _e74);
            let _e87 = (bitcast<i32>(select(0u, 1u, _e74)) != 0i);
            if _e87 {
                let _e91 = params.member.member.member[_e85];
                words.member[_e85] = _e91;
            }
            continue;
            continuing {
                phi_141_ = type_8(select(_e71.member, (_e71.member + 1u), _e74), select(_e71.member_1, _e71.member_1, _e74));
                break if !(_e87);
            }
        }
        let _e96 = params.member.member.member_1;
        words.member[3u] = _e96;
        phi_188_ = type_8(0u, 4u);
        loop {
            let _e99 = phi_188_;
            let _e102 = (_e99.member < _e99.member_1);
            let _e113 = select(type_8().member_1, _e99.member, _e102);
            let _e115 = (bitcast<i32>(select(0u, 1u, _e102)) != 0i);
            if _e115 {
                let _e120 = params.member.member.member_2[_e113];
                words.member[(4u + _e113)] = _e120;
            }
            continue;
            continuing {
                phi_188_ = type_8(select(_e99.member, (_e99.member + 1u), _e102), select(_e99.member_1, _e99.member_1, _e102));
                break if !(_e115);
            }
        }
        let _e125 = params.member.member.member_3;
        words.member[8u] = bitcast<u32>(_e125);
        let _e130 = params.member.member.member_4;
        words.member[9u] = bitcast<u32>(_e130);
        let _e135 = params.member.member.member_5;
        words.member[10u] = bitcast<u32>(_e135);
        let _e140 = params.member.member.member_6;
        words.member[11u] = bitcast<u32>(_e140);
        let _e146 = params.member.member.member_7[0u];
        words.member[12u] = _e146;
        let _e151 = params.member.member.member_7[1u];
        words.member[13u] = _e151;
        phi_263_ = type_8(0u, 3u);
        loop {
            let _e154 = phi_263_;
            let _e157 = (_e154.member < _e154.member_1);
            let _e168 = select(type_8().member_1, _e154.member, _e157);
            let _e170 = (bitcast<i32>(select(0u, 1u, _e157)) != 0i);
            if _e170 {
                let _e177 = params.member.member.member_8[_e168][0u];
                words.member[(14u + (2u * _e168))] = _e177;
                let _e185 = params.member.member.member_8[_e168][1u];
                words.member[(15u + (2u * _e168))] = _e185;
            }
            continue;
            continuing {
                phi_263_ = type_8(select(_e154.member, (_e154.member + 1u), _e157), select(_e154.member_1, _e154.member_1, _e157));
                break if !(_e170);
            }
        }
        let _e191 = params.member.member.member_9[0u];
        words.member[20u] = _e191;
        let _e196 = params.member.member.member_9[1u];
        words.member[21u] = _e196;
        let _e201 = params.member.member.member_10[0u];
        words.member[22u] = _e201;
        let _e206 = params.member.member.member_10[1u];
        words.member[23u] = _e206;
        let _e210 = params.member.member.member_11;
        words.member[24u] = bitcast<u32>(_e210);
        let _e215 = params.member.member.member_12;
        words.member[25u] = bitcast<u32>(_e215);
        let _e220 = params.member.member.member_13;
        words.member[26u] = bitcast<u32>(_e220);
        phi_358_ = type_8(0u, 2u);
        loop {
            let _e224 = phi_358_;
            let _e227 = (_e224.member < _e224.member_1);
            let _e238 = select(type_8().member_1, _e224.member, _e227);
            let _e240 = (bitcast<i32>(select(0u, 1u, _e227)) != 0i);
            if _e240 {
                let _e245 = params.member.member.member_14[_e238];
                words.member[(27u + _e238)] = _e245;
                let _e251 = params.member.member.member_15[_e238];
                words.member[(29u + _e238)] = _e251;
                let _e257 = params.member.member.member_16[_e238];
                words.member[(31u + _e238)] = _e257;
            }
            continue;
            continuing {
                phi_358_ = type_8(select(_e224.member, (_e224.member + 1u), _e227), select(_e224.member_1, _e224.member_1, _e227));
                break if !(_e240);
            }
        }
        let _e261 = params.member.member_1.member;
        words.member[33u] = _e261;
        let _e264 = params.member.member_1.member_1;
        words.member[34u] = _e264;
        let _e267 = params.member.member_1.member_2;
        words.member[35u] = _e267;
        let _e270 = params.member.member_1.member_3;
        words.member[36u] = _e270;
        phi_441_ = type_8(0u, 8u);
        loop {
            let _e273 = phi_441_;
            let _e276 = (_e273.member < _e273.member_1);
            let _e287 = select(type_8().member_1, _e273.member, _e276);
            let _e289 = (bitcast<i32>(select(0u, 1u, _e276)) != 0i);
            if _e289 {
                phi_475_ = type_8(0u, 4u);
                loop {
                    let _e291 = phi_475_;
                    let _e294 = (_e291.member < _e291.member_1);
                    let _e305 = select(type_8().member_1, _e291.member, _e294);
                    let _e307 = (bitcast<i32>(select(0u, 1u, _e294)) != 0i);
                    if _e307 {
                        let _e314 = params.member.member_2.member[_e287][_e305];
                        words.member[((37u + (4u * _e287)) + _e305)] = _e314;
                    }
                    continue;
                    continuing {
                        phi_475_ = type_8(select(_e291.member, (_e291.member + 1u), _e294), select(_e291.member_1, _e291.member_1, _e294));
                        break if !(_e307);
                    }
                }
            }
            continue;
            continuing {
                phi_441_ = type_8(select(_e273.member, (_e273.member + 1u), _e276), select(_e273.member_1, _e273.member_1, _e276));
                break if !(_e289);
            }
        }
        let _e319 = params.member.member_2.member_1;
        words.member[69u] = _e319;
        let _e322 = params.member.member_2.member_2;
        words.member[70u] = _e322;
        let _e325 = params.member.member_2.member_3;
        words.member[71u] = _e325;
        let _e328 = params.member.member_2.member_4;
        words.member[72u] = _e328;
        let _e331 = paths.member[1u];
        local = type_13(array<f32, 4>(_e331.member[0], _e331.member[1], _e331.member[2], _e331.member[3]), array<f32, 4>(_e331.member_1[0], _e331.member_1[1], _e331.member_1[2], _e331.member_1[3]));
        let _e346 = leaves.member[1u];
        local_1 = type_14(array<u32, 3>(_e346.member[0], _e346.member[1], _e346.member[2]), _e346.member_1);
        let _e355 = touches.member[1u];
        let _e358 = pairs.member[1u].member;
        let _e360 = pairs.member[1u].member_1;
        phi_606_ = type_8(0u, 4u);
        loop {
            let _e362 = phi_606_;
            let _e365 = (_e362.member < _e362.member_1);
            let _e376 = select(type_8().member_1, _e362.member, _e365);
            let _e378 = (bitcast<i32>(select(0u, 1u, _e365)) != 0i);
            if _e378 {
                let _e382 = local.member[_e376];
                words.member[(73u + _e376)] = bitcast<u32>(_e382);
                let _e388 = local.member_1[_e376];
                words.member[(77u + _e376)] = bitcast<u32>(_e388);
            }
            continue;
            continuing {
                phi_606_ = type_8(select(_e362.member, (_e362.member + 1u), _e365), select(_e362.member_1, _e362.member_1, _e365));
                break if !(_e378);
            }
        }
        phi_665_ = type_8(0u, 3u);
        loop {
            let _e393 = phi_665_;
            let _e396 = (_e393.member < _e393.member_1);
            let _e407 = select(type_8().member_1, _e393.member, _e396);
            let _e409 = (bitcast<i32>(select(0u, 1u, _e396)) != 0i);
            if _e409 {
                let _e413 = local_1.member[_e407];
                words.member[(81u + _e407)] = _e413;
            }
            continue;
            continuing {
                phi_665_ = type_8(select(_e393.member, (_e393.member + 1u), _e396), select(_e393.member_1, _e393.member_1, _e396));
                break if !(_e409);
            }
        }
        let _e417 = local_1.member_1;
        words.member[84u] = _e417;
        words.member[85u] = _e355.member;
        words.member[86u] = _e355.member_1;
        words.member[87u] = _e355.member_2;
        words.member[88u] = _e355.member_3;
        words.member[89u] = _e355.member_4[0];
        words.member[90u] = _e355.member_4[1];
        words.member[91u] = _e355.member_5;
        words.member[92u] = _e358;
        words.member[93u] = _e360;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_layout(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
