struct type_7 {
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

struct type_8 {
    member: type_7,
}

struct type_10 {
    member: array<u32>,
}

struct type_11 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_13 {
    member: array<type_11>,
}

struct type_15 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<type_15>,
}

@group(0) @binding(0) 
var<storage> params: type_8;
@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(2) 
var<storage> leaves: type_13;
@group(0) @binding(3) 
var<storage> touches: type_22;
@group(0) @binding(4) 
var<storage> pairs: type_24;
@group(0) @binding(5) 
var<storage, read_write> out: type_10;

fn function_(lane_1: u32) {
    var local: type_17;
    var local_1: type_11;
    var phi_122_: type_15;
    var phi_123_: type_15;
    var phi_146_: type_15;
    var phi_169_: type_15;
    var phi_170_: type_15;
    var phi_193_: type_15;
    var phi_284_: type_15;
    var phi_285_: type_15;
    var phi_308_: type_15;
    var phi_354_: type_15;
    var phi_355_: type_15;
    var phi_378_: type_15;
    var phi_388_: type_15;
    var phi_389_: type_15;
    var phi_412_: type_15;
    var phi_504_: type_15;
    var phi_505_: type_15;
    var phi_528_: type_15;
    var phi_563_: type_15;
    var phi_564_: type_15;
    var phi_587_: type_15;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e52 = lane_2;
    if (_e52 == 0u) {
        phi_122_ = type_15(0u, 3u);
        loop {
            let _e61 = phi_122_;
            if (_e61.member < _e61.member_1) {
                phi_123_ = type_15((_e61.member + 1u), _e61.member_1);
                phi_146_ = type_15(1u, _e61.member);
            } else {
                phi_123_ = _e61;
                phi_146_ = type_15(0u, type_15().member_1);
            }
            let _e73 = phi_123_;
            let _e75 = phi_146_;
            let _e79 = (bitcast<i32>(_e75.member) != 0i);
            if _e79 {
                let _e82 = params.member.member[_e75.member_1];
                out.member[_e75.member_1] = _e82;
            }
            continue;
            continuing {
                phi_122_ = _e73;
                break if !(_e79);
            }
        }
        let _e86 = params.member.member_1;
        out.member[3u] = _e86;
        phi_169_ = type_15(0u, 4u);
        loop {
            let _e89 = phi_169_;
            if (_e89.member < _e89.member_1) {
                phi_170_ = type_15((_e89.member + 1u), _e89.member_1);
                phi_193_ = type_15(1u, _e89.member);
            } else {
                phi_170_ = _e89;
                phi_193_ = type_15(0u, type_15().member_1);
            }
            let _e101 = phi_170_;
            let _e103 = phi_193_;
            let _e107 = (bitcast<i32>(_e103.member) != 0i);
            if _e107 {
                let _e111 = params.member.member_2[_e103.member_1];
                out.member[(4u + _e103.member_1)] = _e111;
            }
            continue;
            continuing {
                phi_169_ = _e101;
                break if !(_e107);
            }
        }
        let _e115 = params.member.member_3;
        out.member[8u] = bitcast<u32>(_e115);
        let _e119 = params.member.member_4;
        out.member[9u] = bitcast<u32>(_e119);
        let _e123 = params.member.member_5;
        out.member[10u] = bitcast<u32>(_e123);
        let _e127 = params.member.member_6;
        out.member[11u] = bitcast<u32>(_e127);
        let _e132 = params.member.member_7[0u];
        out.member[12u] = _e132;
        let _e136 = params.member.member_7[1u];
        out.member[13u] = _e136;
        let _e139 = params.member.member_8;
        out.member[14u] = _e139;
        let _e142 = params.member.member_9;
        out.member[15u] = _e142;
        let _e145 = params.member.member_10;
        out.member[16u] = _e145;
        let _e148 = params.member.member_11;
        out.member[17u] = _e148;
        let _e151 = params.member.member_12;
        out.member[18u] = _e151;
        let _e154 = params.member.member_13;
        out.member[19u] = _e154;
        let _e157 = params.member.member_14;
        out.member[20u] = _e157;
        let _e160 = params.member.member_15;
        out.member[21u] = _e160;
        let _e163 = params.member.member_16;
        out.member[22u] = _e163;
        let _e166 = params.member.member_17;
        out.member[23u] = _e166;
        phi_284_ = type_15(0u, 3u);
        loop {
            let _e169 = phi_284_;
            if (_e169.member < _e169.member_1) {
                phi_285_ = type_15((_e169.member + 1u), _e169.member_1);
                phi_308_ = type_15(1u, _e169.member);
            } else {
                phi_285_ = _e169;
                phi_308_ = type_15(0u, type_15().member_1);
            }
            let _e181 = phi_285_;
            let _e183 = phi_308_;
            let _e187 = (bitcast<i32>(_e183.member) != 0i);
            if _e187 {
                let _e193 = params.member.member_18[_e183.member_1][0u];
                out.member[(24u + (2u * _e183.member_1))] = _e193;
                let _e200 = params.member.member_18[_e183.member_1][1u];
                out.member[(25u + (2u * _e183.member_1))] = _e200;
            }
            continue;
            continuing {
                phi_284_ = _e181;
                break if !(_e187);
            }
        }
        let _e205 = params.member.member_19[0u];
        out.member[30u] = _e205;
        let _e209 = params.member.member_19[1u];
        out.member[31u] = _e209;
        phi_354_ = type_15(0u, 8u);
        loop {
            let _e212 = phi_354_;
            if (_e212.member < _e212.member_1) {
                phi_355_ = type_15((_e212.member + 1u), _e212.member_1);
                phi_378_ = type_15(1u, _e212.member);
            } else {
                phi_355_ = _e212;
                phi_378_ = type_15(0u, type_15().member_1);
            }
            let _e224 = phi_355_;
            let _e226 = phi_378_;
            let _e230 = (bitcast<i32>(_e226.member) != 0i);
            if _e230 {
                phi_388_ = type_15(0u, 4u);
                loop {
                    let _e232 = phi_388_;
                    if (_e232.member < _e232.member_1) {
                        phi_389_ = type_15((_e232.member + 1u), _e232.member_1);
                        phi_412_ = type_15(1u, _e232.member);
                    } else {
                        phi_389_ = _e232;
                        phi_412_ = type_15(0u, type_15().member_1);
                    }
                    let _e244 = phi_389_;
                    let _e246 = phi_412_;
                    let _e250 = (bitcast<i32>(_e246.member) != 0i);
                    if _e250 {
                        let _e257 = params.member.member_20[_e226.member_1][_e246.member_1];
                        out.member[((32u + (4u * _e226.member_1)) + _e246.member_1)] = _e257;
                    }
                    continue;
                    continuing {
                        phi_388_ = _e244;
                        break if !(_e250);
                    }
                }
            }
            continue;
            continuing {
                phi_354_ = _e224;
                break if !(_e230);
            }
        }
        let _e262 = paths.member[1u];
        local = type_17(array<f32, 4>(_e262.member[0], _e262.member[1], _e262.member[2], _e262.member[3]), array<f32, 4>(_e262.member_1[0], _e262.member_1[1], _e262.member_1[2], _e262.member_1[3]));
        let _e277 = leaves.member[1u];
        local_1 = type_11(array<u32, 3>(_e277.member[0], _e277.member[1], _e277.member[2]), _e277.member_1);
        let _e286 = touches.member[1u];
        let _e289 = pairs.member[1u].member;
        let _e291 = pairs.member[1u].member_1;
        phi_504_ = type_15(0u, 4u);
        loop {
            let _e293 = phi_504_;
            if (_e293.member < _e293.member_1) {
                phi_505_ = type_15((_e293.member + 1u), _e293.member_1);
                phi_528_ = type_15(1u, _e293.member);
            } else {
                phi_505_ = _e293;
                phi_528_ = type_15(0u, type_15().member_1);
            }
            let _e305 = phi_505_;
            let _e307 = phi_528_;
            let _e311 = (bitcast<i32>(_e307.member) != 0i);
            if _e311 {
                let _e315 = local.member[_e307.member_1];
                out.member[(64u + _e307.member_1)] = bitcast<u32>(_e315);
                let _e321 = local.member_1[_e307.member_1];
                out.member[(68u + _e307.member_1)] = bitcast<u32>(_e321);
            }
            continue;
            continuing {
                phi_504_ = _e305;
                break if !(_e311);
            }
        }
        phi_563_ = type_15(0u, 3u);
        loop {
            let _e326 = phi_563_;
            if (_e326.member < _e326.member_1) {
                phi_564_ = type_15((_e326.member + 1u), _e326.member_1);
                phi_587_ = type_15(1u, _e326.member);
            } else {
                phi_564_ = _e326;
                phi_587_ = type_15(0u, type_15().member_1);
            }
            let _e338 = phi_564_;
            let _e340 = phi_587_;
            let _e344 = (bitcast<i32>(_e340.member) != 0i);
            if _e344 {
                let _e348 = local_1.member[_e340.member_1];
                out.member[(72u + _e340.member_1)] = _e348;
            }
            continue;
            continuing {
                phi_563_ = _e338;
                break if !(_e344);
            }
        }
        let _e352 = local_1.member_1;
        out.member[75u] = _e352;
        out.member[76u] = _e286.member;
        out.member[77u] = _e286.member_1;
        out.member[78u] = _e286.member_2;
        out.member[79u] = _e286.member_3;
        out.member[80u] = _e286.member_4[0];
        out.member[81u] = _e286.member_4[1];
        out.member[82u] = _e289;
        out.member[83u] = _e291;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_layout(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
