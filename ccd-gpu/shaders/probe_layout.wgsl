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
    var phi_142_: type_8;
    var phi_165_: type_8;
    var phi_188_: type_8;
    var phi_189_: type_8;
    var phi_212_: type_8;
    var phi_263_: type_8;
    var phi_264_: type_8;
    var phi_287_: type_8;
    var phi_358_: type_8;
    var phi_359_: type_8;
    var phi_382_: type_8;
    var phi_441_: type_8;
    var phi_442_: type_8;
    var phi_465_: type_8;
    var phi_475_: type_8;
    var phi_476_: type_8;
    var phi_499_: type_8;
    var phi_606_: type_8;
    var phi_607_: type_8;
    var phi_630_: type_8;
    var phi_665_: type_8;
    var phi_666_: type_8;
    var phi_689_: type_8;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e60 = lane_2;
    if (_e60 == 0u) {
        phi_141_ = type_8(0u, 3u);
        loop {
            let _e71 = phi_141_;
            if (_e71.member < _e71.member_1) {
                phi_142_ = type_8((_e71.member + 1u), _e71.member_1);
                phi_165_ = type_8(1u, _e71.member);
            } else {
                phi_142_ = _e71;
                phi_165_ = type_8(0u, type_8().member_1);
            }
            let _e83 = phi_142_;
            let _e85 = phi_165_;
            let _e89 = (bitcast<i32>(_e85.member) != 0i);
            if _e89 {
                let _e93 = params.member.member.member[_e85.member_1];
                words.member[_e85.member_1] = _e93;
            }
            continue;
            continuing {
                phi_141_ = _e83;
                break if !(_e89);
            }
        }
        let _e98 = params.member.member.member_1;
        words.member[3u] = _e98;
        phi_188_ = type_8(0u, 4u);
        loop {
            let _e101 = phi_188_;
            if (_e101.member < _e101.member_1) {
                phi_189_ = type_8((_e101.member + 1u), _e101.member_1);
                phi_212_ = type_8(1u, _e101.member);
            } else {
                phi_189_ = _e101;
                phi_212_ = type_8(0u, type_8().member_1);
            }
            let _e113 = phi_189_;
            let _e115 = phi_212_;
            let _e119 = (bitcast<i32>(_e115.member) != 0i);
            if _e119 {
                let _e124 = params.member.member.member_2[_e115.member_1];
                words.member[(4u + _e115.member_1)] = _e124;
            }
            continue;
            continuing {
                phi_188_ = _e113;
                break if !(_e119);
            }
        }
        let _e129 = params.member.member.member_3;
        words.member[8u] = bitcast<u32>(_e129);
        let _e134 = params.member.member.member_4;
        words.member[9u] = bitcast<u32>(_e134);
        let _e139 = params.member.member.member_5;
        words.member[10u] = bitcast<u32>(_e139);
        let _e144 = params.member.member.member_6;
        words.member[11u] = bitcast<u32>(_e144);
        let _e150 = params.member.member.member_7[0u];
        words.member[12u] = _e150;
        let _e155 = params.member.member.member_7[1u];
        words.member[13u] = _e155;
        phi_263_ = type_8(0u, 3u);
        loop {
            let _e158 = phi_263_;
            if (_e158.member < _e158.member_1) {
                phi_264_ = type_8((_e158.member + 1u), _e158.member_1);
                phi_287_ = type_8(1u, _e158.member);
            } else {
                phi_264_ = _e158;
                phi_287_ = type_8(0u, type_8().member_1);
            }
            let _e170 = phi_264_;
            let _e172 = phi_287_;
            let _e176 = (bitcast<i32>(_e172.member) != 0i);
            if _e176 {
                let _e183 = params.member.member.member_8[_e172.member_1][0u];
                words.member[(14u + (2u * _e172.member_1))] = _e183;
                let _e191 = params.member.member.member_8[_e172.member_1][1u];
                words.member[(15u + (2u * _e172.member_1))] = _e191;
            }
            continue;
            continuing {
                phi_263_ = _e170;
                break if !(_e176);
            }
        }
        let _e197 = params.member.member.member_9[0u];
        words.member[20u] = _e197;
        let _e202 = params.member.member.member_9[1u];
        words.member[21u] = _e202;
        let _e207 = params.member.member.member_10[0u];
        words.member[22u] = _e207;
        let _e212 = params.member.member.member_10[1u];
        words.member[23u] = _e212;
        let _e216 = params.member.member.member_11;
        words.member[24u] = bitcast<u32>(_e216);
        let _e221 = params.member.member.member_12;
        words.member[25u] = bitcast<u32>(_e221);
        let _e226 = params.member.member.member_13;
        words.member[26u] = bitcast<u32>(_e226);
        phi_358_ = type_8(0u, 2u);
        loop {
            let _e230 = phi_358_;
            if (_e230.member < _e230.member_1) {
                phi_359_ = type_8((_e230.member + 1u), _e230.member_1);
                phi_382_ = type_8(1u, _e230.member);
            } else {
                phi_359_ = _e230;
                phi_382_ = type_8(0u, type_8().member_1);
            }
            let _e242 = phi_359_;
            let _e244 = phi_382_;
            let _e248 = (bitcast<i32>(_e244.member) != 0i);
            if _e248 {
                let _e253 = params.member.member.member_14[_e244.member_1];
                words.member[(27u + _e244.member_1)] = _e253;
                let _e259 = params.member.member.member_15[_e244.member_1];
                words.member[(29u + _e244.member_1)] = _e259;
                let _e265 = params.member.member.member_16[_e244.member_1];
                words.member[(31u + _e244.member_1)] = _e265;
            }
            continue;
            continuing {
                phi_358_ = _e242;
                break if !(_e248);
            }
        }
        let _e269 = params.member.member_1.member;
        words.member[33u] = _e269;
        let _e272 = params.member.member_1.member_1;
        words.member[34u] = _e272;
        let _e275 = params.member.member_1.member_2;
        words.member[35u] = _e275;
        let _e278 = params.member.member_1.member_3;
        words.member[36u] = _e278;
        phi_441_ = type_8(0u, 8u);
        loop {
            let _e281 = phi_441_;
            if (_e281.member < _e281.member_1) {
                phi_442_ = type_8((_e281.member + 1u), _e281.member_1);
                phi_465_ = type_8(1u, _e281.member);
            } else {
                phi_442_ = _e281;
                phi_465_ = type_8(0u, type_8().member_1);
            }
            let _e293 = phi_442_;
            let _e295 = phi_465_;
            let _e299 = (bitcast<i32>(_e295.member) != 0i);
            if _e299 {
                phi_475_ = type_8(0u, 4u);
                loop {
                    let _e301 = phi_475_;
                    if (_e301.member < _e301.member_1) {
                        phi_476_ = type_8((_e301.member + 1u), _e301.member_1);
                        phi_499_ = type_8(1u, _e301.member);
                    } else {
                        phi_476_ = _e301;
                        phi_499_ = type_8(0u, type_8().member_1);
                    }
                    let _e313 = phi_476_;
                    let _e315 = phi_499_;
                    let _e319 = (bitcast<i32>(_e315.member) != 0i);
                    if _e319 {
                        let _e326 = params.member.member_2.member[_e295.member_1][_e315.member_1];
                        words.member[((37u + (4u * _e295.member_1)) + _e315.member_1)] = _e326;
                    }
                    continue;
                    continuing {
                        phi_475_ = _e313;
                        break if !(_e319);
                    }
                }
            }
            continue;
            continuing {
                phi_441_ = _e293;
                break if !(_e299);
            }
        }
        let _e331 = params.member.member_2.member_1;
        words.member[69u] = _e331;
        let _e334 = params.member.member_2.member_2;
        words.member[70u] = _e334;
        let _e337 = params.member.member_2.member_3;
        words.member[71u] = _e337;
        let _e340 = params.member.member_2.member_4;
        words.member[72u] = _e340;
        let _e343 = paths.member[1u];
        local = type_13(array<f32, 4>(_e343.member[0], _e343.member[1], _e343.member[2], _e343.member[3]), array<f32, 4>(_e343.member_1[0], _e343.member_1[1], _e343.member_1[2], _e343.member_1[3]));
        let _e358 = leaves.member[1u];
        local_1 = type_14(array<u32, 3>(_e358.member[0], _e358.member[1], _e358.member[2]), _e358.member_1);
        let _e367 = touches.member[1u];
        let _e370 = pairs.member[1u].member;
        let _e372 = pairs.member[1u].member_1;
        phi_606_ = type_8(0u, 4u);
        loop {
            let _e374 = phi_606_;
            if (_e374.member < _e374.member_1) {
                phi_607_ = type_8((_e374.member + 1u), _e374.member_1);
                phi_630_ = type_8(1u, _e374.member);
            } else {
                phi_607_ = _e374;
                phi_630_ = type_8(0u, type_8().member_1);
            }
            let _e386 = phi_607_;
            let _e388 = phi_630_;
            let _e392 = (bitcast<i32>(_e388.member) != 0i);
            if _e392 {
                let _e396 = local.member[_e388.member_1];
                words.member[(73u + _e388.member_1)] = bitcast<u32>(_e396);
                let _e402 = local.member_1[_e388.member_1];
                words.member[(77u + _e388.member_1)] = bitcast<u32>(_e402);
            }
            continue;
            continuing {
                phi_606_ = _e386;
                break if !(_e392);
            }
        }
        phi_665_ = type_8(0u, 3u);
        loop {
            let _e407 = phi_665_;
            if (_e407.member < _e407.member_1) {
                phi_666_ = type_8((_e407.member + 1u), _e407.member_1);
                phi_689_ = type_8(1u, _e407.member);
            } else {
                phi_666_ = _e407;
                phi_689_ = type_8(0u, type_8().member_1);
            }
            let _e419 = phi_666_;
            let _e421 = phi_689_;
            let _e425 = (bitcast<i32>(_e421.member) != 0i);
            if _e425 {
                let _e429 = local_1.member[_e421.member_1];
                words.member[(81u + _e421.member_1)] = _e429;
            }
            continue;
            continuing {
                phi_665_ = _e419;
                break if !(_e425);
            }
        }
        let _e433 = local_1.member_1;
        words.member[84u] = _e433;
        words.member[85u] = _e367.member;
        words.member[86u] = _e367.member_1;
        words.member[87u] = _e367.member_2;
        words.member[88u] = _e367.member_3;
        words.member[89u] = _e367.member_4[0];
        words.member[90u] = _e367.member_4[1];
        words.member[91u] = _e367.member_5;
        words.member[92u] = _e370;
        words.member[93u] = _e372;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_layout(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
