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
}

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_9 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
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
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<type_10>,
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
var<storage, read_write> words: type_9;

fn function_(lane_1: u32) {
    var local: type_13;
    var local_1: type_14;
    var phi_128_: type_10;
    var phi_129_: type_10;
    var phi_152_: type_10;
    var phi_175_: type_10;
    var phi_176_: type_10;
    var phi_199_: type_10;
    var phi_250_: type_10;
    var phi_251_: type_10;
    var phi_274_: type_10;
    var phi_346_: type_10;
    var phi_347_: type_10;
    var phi_370_: type_10;
    var phi_380_: type_10;
    var phi_381_: type_10;
    var phi_404_: type_10;
    var phi_511_: type_10;
    var phi_512_: type_10;
    var phi_535_: type_10;
    var phi_570_: type_10;
    var phi_571_: type_10;
    var phi_594_: type_10;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e52 = lane_2;
    if (_e52 == 0u) {
        phi_128_ = type_10(0u, 3u);
        loop {
            let _e63 = phi_128_;
            if (_e63.member < _e63.member_1) {
                phi_129_ = type_10((_e63.member + 1u), _e63.member_1);
                phi_152_ = type_10(1u, _e63.member);
            } else {
                phi_129_ = _e63;
                phi_152_ = type_10(0u, type_10().member_1);
            }
            let _e75 = phi_129_;
            let _e77 = phi_152_;
            let _e81 = (bitcast<i32>(_e77.member) != 0i);
            if _e81 {
                let _e85 = params.member.member.member[_e77.member_1];
                words.member[_e77.member_1] = _e85;
            }
            continue;
            continuing {
                phi_128_ = _e75;
                break if !(_e81);
            }
        }
        let _e90 = params.member.member.member_1;
        words.member[3u] = _e90;
        phi_175_ = type_10(0u, 4u);
        loop {
            let _e93 = phi_175_;
            if (_e93.member < _e93.member_1) {
                phi_176_ = type_10((_e93.member + 1u), _e93.member_1);
                phi_199_ = type_10(1u, _e93.member);
            } else {
                phi_176_ = _e93;
                phi_199_ = type_10(0u, type_10().member_1);
            }
            let _e105 = phi_176_;
            let _e107 = phi_199_;
            let _e111 = (bitcast<i32>(_e107.member) != 0i);
            if _e111 {
                let _e116 = params.member.member.member_2[_e107.member_1];
                words.member[(4u + _e107.member_1)] = _e116;
            }
            continue;
            continuing {
                phi_175_ = _e105;
                break if !(_e111);
            }
        }
        let _e121 = params.member.member.member_3;
        words.member[8u] = bitcast<u32>(_e121);
        let _e126 = params.member.member.member_4;
        words.member[9u] = bitcast<u32>(_e126);
        let _e131 = params.member.member.member_5;
        words.member[10u] = bitcast<u32>(_e131);
        let _e136 = params.member.member.member_6;
        words.member[11u] = bitcast<u32>(_e136);
        let _e142 = params.member.member.member_7[0u];
        words.member[12u] = _e142;
        let _e147 = params.member.member.member_7[1u];
        words.member[13u] = _e147;
        phi_250_ = type_10(0u, 3u);
        loop {
            let _e150 = phi_250_;
            if (_e150.member < _e150.member_1) {
                phi_251_ = type_10((_e150.member + 1u), _e150.member_1);
                phi_274_ = type_10(1u, _e150.member);
            } else {
                phi_251_ = _e150;
                phi_274_ = type_10(0u, type_10().member_1);
            }
            let _e162 = phi_251_;
            let _e164 = phi_274_;
            let _e168 = (bitcast<i32>(_e164.member) != 0i);
            if _e168 {
                let _e175 = params.member.member.member_8[_e164.member_1][0u];
                words.member[(14u + (2u * _e164.member_1))] = _e175;
                let _e183 = params.member.member.member_8[_e164.member_1][1u];
                words.member[(15u + (2u * _e164.member_1))] = _e183;
            }
            continue;
            continuing {
                phi_250_ = _e162;
                break if !(_e168);
            }
        }
        let _e189 = params.member.member.member_9[0u];
        words.member[20u] = _e189;
        let _e194 = params.member.member.member_9[1u];
        words.member[21u] = _e194;
        let _e199 = params.member.member.member_10[0u];
        words.member[22u] = _e199;
        let _e204 = params.member.member.member_10[1u];
        words.member[23u] = _e204;
        let _e207 = params.member.member_1.member;
        words.member[24u] = _e207;
        let _e210 = params.member.member_1.member_1;
        words.member[25u] = _e210;
        let _e213 = params.member.member_1.member_2;
        words.member[26u] = _e213;
        let _e216 = params.member.member_1.member_3;
        words.member[27u] = _e216;
        phi_346_ = type_10(0u, 8u);
        loop {
            let _e219 = phi_346_;
            if (_e219.member < _e219.member_1) {
                phi_347_ = type_10((_e219.member + 1u), _e219.member_1);
                phi_370_ = type_10(1u, _e219.member);
            } else {
                phi_347_ = _e219;
                phi_370_ = type_10(0u, type_10().member_1);
            }
            let _e231 = phi_347_;
            let _e233 = phi_370_;
            let _e237 = (bitcast<i32>(_e233.member) != 0i);
            if _e237 {
                phi_380_ = type_10(0u, 4u);
                loop {
                    let _e239 = phi_380_;
                    if (_e239.member < _e239.member_1) {
                        phi_381_ = type_10((_e239.member + 1u), _e239.member_1);
                        phi_404_ = type_10(1u, _e239.member);
                    } else {
                        phi_381_ = _e239;
                        phi_404_ = type_10(0u, type_10().member_1);
                    }
                    let _e251 = phi_381_;
                    let _e253 = phi_404_;
                    let _e257 = (bitcast<i32>(_e253.member) != 0i);
                    if _e257 {
                        let _e264 = params.member.member_2.member[_e233.member_1][_e253.member_1];
                        words.member[((28u + (4u * _e233.member_1)) + _e253.member_1)] = _e264;
                    }
                    continue;
                    continuing {
                        phi_380_ = _e251;
                        break if !(_e257);
                    }
                }
            }
            continue;
            continuing {
                phi_346_ = _e231;
                break if !(_e237);
            }
        }
        let _e269 = params.member.member_2.member_1;
        words.member[60u] = _e269;
        let _e272 = params.member.member_2.member_2;
        words.member[61u] = _e272;
        let _e275 = params.member.member_2.member_3;
        words.member[62u] = _e275;
        let _e278 = params.member.member_2.member_4;
        words.member[63u] = _e278;
        let _e281 = paths.member[1u];
        local = type_13(array<f32, 4>(_e281.member[0], _e281.member[1], _e281.member[2], _e281.member[3]), array<f32, 4>(_e281.member_1[0], _e281.member_1[1], _e281.member_1[2], _e281.member_1[3]));
        let _e296 = leaves.member[1u];
        local_1 = type_14(array<u32, 3>(_e296.member[0], _e296.member[1], _e296.member[2]), _e296.member_1);
        let _e305 = touches.member[1u];
        let _e308 = pairs.member[1u].member;
        let _e310 = pairs.member[1u].member_1;
        phi_511_ = type_10(0u, 4u);
        loop {
            let _e312 = phi_511_;
            if (_e312.member < _e312.member_1) {
                phi_512_ = type_10((_e312.member + 1u), _e312.member_1);
                phi_535_ = type_10(1u, _e312.member);
            } else {
                phi_512_ = _e312;
                phi_535_ = type_10(0u, type_10().member_1);
            }
            let _e324 = phi_512_;
            let _e326 = phi_535_;
            let _e330 = (bitcast<i32>(_e326.member) != 0i);
            if _e330 {
                let _e334 = local.member[_e326.member_1];
                words.member[(64u + _e326.member_1)] = bitcast<u32>(_e334);
                let _e340 = local.member_1[_e326.member_1];
                words.member[(68u + _e326.member_1)] = bitcast<u32>(_e340);
            }
            continue;
            continuing {
                phi_511_ = _e324;
                break if !(_e330);
            }
        }
        phi_570_ = type_10(0u, 3u);
        loop {
            let _e345 = phi_570_;
            if (_e345.member < _e345.member_1) {
                phi_571_ = type_10((_e345.member + 1u), _e345.member_1);
                phi_594_ = type_10(1u, _e345.member);
            } else {
                phi_571_ = _e345;
                phi_594_ = type_10(0u, type_10().member_1);
            }
            let _e357 = phi_571_;
            let _e359 = phi_594_;
            let _e363 = (bitcast<i32>(_e359.member) != 0i);
            if _e363 {
                let _e367 = local_1.member[_e359.member_1];
                words.member[(72u + _e359.member_1)] = _e367;
            }
            continue;
            continuing {
                phi_570_ = _e357;
                break if !(_e363);
            }
        }
        let _e371 = local_1.member_1;
        words.member[75u] = _e371;
        words.member[76u] = _e305.member;
        words.member[77u] = _e305.member_1;
        words.member[78u] = _e305.member_2;
        words.member[79u] = _e305.member_3;
        words.member[80u] = _e305.member_4[0];
        words.member[81u] = _e305.member_4[1];
        words.member[82u] = _e308;
        words.member[83u] = _e310;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_layout(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
