struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_10 {
    member: type_8,
}

struct type_14 {
    member: array<u32>,
}

struct type_16 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_19 {
    member: array<type_16>,
}

struct type_27 {
    member: u32,
    member_1: u32,
}

struct type_32 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_36 {
    member: array<type_32>,
}

struct type_43 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_46 {
    member: array<type_43>,
}

struct type_50 {
    member: array<type_27>,
}

var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_10;
@group(0) @binding(1) 
var<storage> paths: type_36;
@group(0) @binding(2) 
var<storage> leaves: type_19;
@group(0) @binding(3) 
var<storage> touches: type_46;
@group(0) @binding(4) 
var<storage> pairs: type_50;
@group(0) @binding(5) 
var<storage, read_write> out: type_14;

fn function_() {
    var local: type_32;
    var local_1: type_16;
    var phi_122_: type_27;
    var phi_123_: type_27;
    var phi_146_: type_27;
    var phi_169_: type_27;
    var phi_170_: type_27;
    var phi_193_: type_27;
    var phi_284_: type_27;
    var phi_285_: type_27;
    var phi_308_: type_27;
    var phi_354_: type_27;
    var phi_355_: type_27;
    var phi_378_: type_27;
    var phi_388_: type_27;
    var phi_389_: type_27;
    var phi_412_: type_27;
    var phi_504_: type_27;
    var phi_505_: type_27;
    var phi_528_: type_27;
    var phi_563_: type_27;
    var phi_564_: type_27;
    var phi_587_: type_27;

    let _e55 = lane_1;
    if (_e55 == 0u) {
        phi_122_ = type_27(0u, 3u);
        loop {
            let _e64 = phi_122_;
            if (_e64.member < _e64.member_1) {
                phi_123_ = type_27((_e64.member + 1u), _e64.member_1);
                phi_146_ = type_27(1u, _e64.member);
            } else {
                phi_123_ = _e64;
                phi_146_ = type_27(0u, type_27().member_1);
            }
            let _e78 = phi_123_;
            let _e80 = phi_146_;
            let _e84 = (bitcast<i32>(_e80.member) != 0i);
            if _e84 {
                if (_e80.member_1 < 3u) {
                } else {
                    return;
                }
                let _e88 = params.member.member[_e80.member_1];
                out.member[_e80.member_1] = _e88;
            }
            continue;
            continuing {
                phi_122_ = _e78;
                break if !(_e84);
            }
        }
        let _e92 = params.member.member_1;
        out.member[3u] = _e92;
        phi_169_ = type_27(0u, 4u);
        loop {
            let _e95 = phi_169_;
            if (_e95.member < _e95.member_1) {
                phi_170_ = type_27((_e95.member + 1u), _e95.member_1);
                phi_193_ = type_27(1u, _e95.member);
            } else {
                phi_170_ = _e95;
                phi_193_ = type_27(0u, type_27().member_1);
            }
            let _e109 = phi_170_;
            let _e111 = phi_193_;
            let _e115 = (bitcast<i32>(_e111.member) != 0i);
            if _e115 {
                if (_e111.member_1 < 4u) {
                } else {
                    return;
                }
                let _e120 = params.member.member_2[_e111.member_1];
                out.member[(4u + _e111.member_1)] = _e120;
            }
            continue;
            continuing {
                phi_169_ = _e109;
                break if !(_e115);
            }
        }
        let _e124 = params.member.member_3;
        out.member[8u] = bitcast<u32>(_e124);
        let _e128 = params.member.member_4;
        out.member[9u] = bitcast<u32>(_e128);
        let _e132 = params.member.member_5;
        out.member[10u] = bitcast<u32>(_e132);
        let _e136 = params.member.member_6;
        out.member[11u] = bitcast<u32>(_e136);
        let _e141 = params.member.member_7[0u];
        out.member[12u] = _e141;
        let _e145 = params.member.member_7[1u];
        out.member[13u] = _e145;
        let _e148 = params.member.member_8;
        out.member[14u] = _e148;
        let _e151 = params.member.member_9;
        out.member[15u] = _e151;
        let _e154 = params.member.member_10;
        out.member[16u] = _e154;
        let _e157 = params.member.member_11;
        out.member[17u] = _e157;
        let _e160 = params.member.member_12;
        out.member[18u] = _e160;
        let _e163 = params.member.member_13;
        out.member[19u] = _e163;
        let _e166 = params.member.member_14;
        out.member[20u] = _e166;
        let _e169 = params.member.member_15;
        out.member[21u] = _e169;
        let _e172 = params.member.member_16;
        out.member[22u] = _e172;
        let _e175 = params.member.member_17;
        out.member[23u] = _e175;
        phi_284_ = type_27(0u, 3u);
        loop {
            let _e178 = phi_284_;
            if (_e178.member < _e178.member_1) {
                phi_285_ = type_27((_e178.member + 1u), _e178.member_1);
                phi_308_ = type_27(1u, _e178.member);
            } else {
                phi_285_ = _e178;
                phi_308_ = type_27(0u, type_27().member_1);
            }
            let _e192 = phi_285_;
            let _e194 = phi_308_;
            let _e198 = (bitcast<i32>(_e194.member) != 0i);
            if _e198 {
                if (_e194.member_1 < 3u) {
                } else {
                    return;
                }
                let _e205 = params.member.member_18[_e194.member_1][0u];
                out.member[(24u + (2u * _e194.member_1))] = _e205;
                if (_e194.member_1 < 3u) {
                } else {
                    return;
                }
                let _e213 = params.member.member_18[_e194.member_1][1u];
                out.member[(25u + (2u * _e194.member_1))] = _e213;
            }
            continue;
            continuing {
                phi_284_ = _e192;
                break if !(_e198);
            }
        }
        let _e218 = params.member.member_19[0u];
        out.member[30u] = _e218;
        let _e222 = params.member.member_19[1u];
        out.member[31u] = _e222;
        phi_354_ = type_27(0u, 8u);
        loop {
            let _e225 = phi_354_;
            if (_e225.member < _e225.member_1) {
                phi_355_ = type_27((_e225.member + 1u), _e225.member_1);
                phi_378_ = type_27(1u, _e225.member);
            } else {
                phi_355_ = _e225;
                phi_378_ = type_27(0u, type_27().member_1);
            }
            let _e239 = phi_355_;
            let _e241 = phi_378_;
            let _e245 = (bitcast<i32>(_e241.member) != 0i);
            if _e245 {
                phi_388_ = type_27(0u, 4u);
                loop {
                    let _e247 = phi_388_;
                    if (_e247.member < _e247.member_1) {
                        phi_389_ = type_27((_e247.member + 1u), _e247.member_1);
                        phi_412_ = type_27(1u, _e247.member);
                    } else {
                        phi_389_ = _e247;
                        phi_412_ = type_27(0u, type_27().member_1);
                    }
                    let _e261 = phi_389_;
                    let _e263 = phi_412_;
                    let _e267 = (bitcast<i32>(_e263.member) != 0i);
                    if _e267 {
                        if (_e241.member_1 < 8u) {
                        } else {
                            return;
                        }
                        if (_e263.member_1 < 4u) {
                        } else {
                            return;
                        }
                        let _e276 = params.member.member_20[_e241.member_1][_e263.member_1];
                        out.member[((32u + (4u * _e241.member_1)) + _e263.member_1)] = _e276;
                    }
                    continue;
                    continuing {
                        phi_388_ = _e261;
                        break if !(_e267);
                    }
                }
            }
            continue;
            continuing {
                phi_354_ = _e239;
                break if !(_e245);
            }
        }
        let _e281 = paths.member[1u];
        local = type_32(array<f32, 4>(_e281.member[0], _e281.member[1], _e281.member[2], _e281.member[3]), array<f32, 4>(_e281.member_1[0], _e281.member_1[1], _e281.member_1[2], _e281.member_1[3]));
        let _e296 = leaves.member[1u];
        local_1 = type_16(array<u32, 3>(_e296.member[0], _e296.member[1], _e296.member[2]), _e296.member_1);
        let _e305 = touches.member[1u];
        let _e308 = pairs.member[1u].member;
        let _e310 = pairs.member[1u].member_1;
        phi_504_ = type_27(0u, 4u);
        loop {
            let _e312 = phi_504_;
            if (_e312.member < _e312.member_1) {
                phi_505_ = type_27((_e312.member + 1u), _e312.member_1);
                phi_528_ = type_27(1u, _e312.member);
            } else {
                phi_505_ = _e312;
                phi_528_ = type_27(0u, type_27().member_1);
            }
            let _e326 = phi_505_;
            let _e328 = phi_528_;
            let _e332 = (bitcast<i32>(_e328.member) != 0i);
            if _e332 {
                if (_e328.member_1 < 4u) {
                } else {
                    return;
                }
                let _e337 = local.member[_e328.member_1];
                out.member[(64u + _e328.member_1)] = bitcast<u32>(_e337);
                if (_e328.member_1 < 4u) {
                } else {
                    return;
                }
                let _e344 = local.member_1[_e328.member_1];
                out.member[(68u + _e328.member_1)] = bitcast<u32>(_e344);
            }
            continue;
            continuing {
                phi_504_ = _e326;
                break if !(_e332);
            }
        }
        phi_563_ = type_27(0u, 3u);
        loop {
            let _e349 = phi_563_;
            if (_e349.member < _e349.member_1) {
                phi_564_ = type_27((_e349.member + 1u), _e349.member_1);
                phi_587_ = type_27(1u, _e349.member);
            } else {
                phi_564_ = _e349;
                phi_587_ = type_27(0u, type_27().member_1);
            }
            let _e363 = phi_564_;
            let _e365 = phi_587_;
            let _e369 = (bitcast<i32>(_e365.member) != 0i);
            if _e369 {
                if (_e365.member_1 < 3u) {
                } else {
                    return;
                }
                let _e374 = local_1.member[_e365.member_1];
                out.member[(72u + _e365.member_1)] = _e374;
            }
            continue;
            continuing {
                phi_563_ = _e363;
                break if !(_e369);
            }
        }
        let _e378 = local_1.member_1;
        out.member[75u] = _e378;
        out.member[76u] = _e305.member;
        out.member[77u] = _e305.member_1;
        out.member[78u] = _e305.member_2;
        out.member[79u] = _e305.member_3;
        out.member[80u] = _e305.member_4[0];
        out.member[81u] = _e305.member_4[1];
        out.member[82u] = _e308;
        out.member[83u] = _e310;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_layout(@builtin(local_invocation_index) lane: u32) {
    lane_1 = lane;
    function_();
}
