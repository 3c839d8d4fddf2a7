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
    var phi_126_: type_8;
    var phi_127_: type_8;
    var phi_150_: type_8;
    var phi_173_: type_8;
    var phi_174_: type_8;
    var phi_197_: type_8;
    var phi_248_: type_8;
    var phi_249_: type_8;
    var phi_272_: type_8;
    var phi_334_: type_8;
    var phi_335_: type_8;
    var phi_358_: type_8;
    var phi_368_: type_8;
    var phi_369_: type_8;
    var phi_392_: type_8;
    var phi_499_: type_8;
    var phi_500_: type_8;
    var phi_523_: type_8;
    var phi_558_: type_8;
    var phi_559_: type_8;
    var phi_582_: type_8;
    var lane_2: u32;

    lane_2 = lane_1;
    let _e50 = lane_2;
    if (_e50 == 0u) {
        phi_126_ = type_8(0u, 3u);
        loop {
            let _e61 = phi_126_;
            if (_e61.member < _e61.member_1) {
                phi_127_ = type_8((_e61.member + 1u), _e61.member_1);
                phi_150_ = type_8(1u, _e61.member);
            } else {
                phi_127_ = _e61;
                phi_150_ = type_8(0u, type_8().member_1);
            }
            let _e73 = phi_127_;
            let _e75 = phi_150_;
            let _e79 = (bitcast<i32>(_e75.member) != 0i);
            if _e79 {
                let _e83 = params.member.member.member[_e75.member_1];
                words.member[_e75.member_1] = _e83;
            }
            continue;
            continuing {
                phi_126_ = _e73;
                break if !(_e79);
            }
        }
        let _e88 = params.member.member.member_1;
        words.member[3u] = _e88;
        phi_173_ = type_8(0u, 4u);
        loop {
            let _e91 = phi_173_;
            if (_e91.member < _e91.member_1) {
                phi_174_ = type_8((_e91.member + 1u), _e91.member_1);
                phi_197_ = type_8(1u, _e91.member);
            } else {
                phi_174_ = _e91;
                phi_197_ = type_8(0u, type_8().member_1);
            }
            let _e103 = phi_174_;
            let _e105 = phi_197_;
            let _e109 = (bitcast<i32>(_e105.member) != 0i);
            if _e109 {
                let _e114 = params.member.member.member_2[_e105.member_1];
                words.member[(4u + _e105.member_1)] = _e114;
            }
            continue;
            continuing {
                phi_173_ = _e103;
                break if !(_e109);
            }
        }
        let _e119 = params.member.member.member_3;
        words.member[8u] = bitcast<u32>(_e119);
        let _e124 = params.member.member.member_4;
        words.member[9u] = bitcast<u32>(_e124);
        let _e129 = params.member.member.member_5;
        words.member[10u] = bitcast<u32>(_e129);
        let _e134 = params.member.member.member_6;
        words.member[11u] = bitcast<u32>(_e134);
        let _e140 = params.member.member.member_7[0u];
        words.member[12u] = _e140;
        let _e145 = params.member.member.member_7[1u];
        words.member[13u] = _e145;
        phi_248_ = type_8(0u, 3u);
        loop {
            let _e148 = phi_248_;
            if (_e148.member < _e148.member_1) {
                phi_249_ = type_8((_e148.member + 1u), _e148.member_1);
                phi_272_ = type_8(1u, _e148.member);
            } else {
                phi_249_ = _e148;
                phi_272_ = type_8(0u, type_8().member_1);
            }
            let _e160 = phi_249_;
            let _e162 = phi_272_;
            let _e166 = (bitcast<i32>(_e162.member) != 0i);
            if _e166 {
                let _e173 = params.member.member.member_8[_e162.member_1][0u];
                words.member[(14u + (2u * _e162.member_1))] = _e173;
                let _e181 = params.member.member.member_8[_e162.member_1][1u];
                words.member[(15u + (2u * _e162.member_1))] = _e181;
            }
            continue;
            continuing {
                phi_248_ = _e160;
                break if !(_e166);
            }
        }
        let _e187 = params.member.member.member_9[0u];
        words.member[20u] = _e187;
        let _e192 = params.member.member.member_9[1u];
        words.member[21u] = _e192;
        let _e195 = params.member.member_1.member;
        words.member[22u] = _e195;
        let _e198 = params.member.member_1.member_1;
        words.member[23u] = _e198;
        let _e201 = params.member.member_1.member_2;
        words.member[24u] = _e201;
        let _e204 = params.member.member_1.member_3;
        words.member[25u] = _e204;
        phi_334_ = type_8(0u, 8u);
        loop {
            let _e207 = phi_334_;
            if (_e207.member < _e207.member_1) {
                phi_335_ = type_8((_e207.member + 1u), _e207.member_1);
                phi_358_ = type_8(1u, _e207.member);
            } else {
                phi_335_ = _e207;
                phi_358_ = type_8(0u, type_8().member_1);
            }
            let _e219 = phi_335_;
            let _e221 = phi_358_;
            let _e225 = (bitcast<i32>(_e221.member) != 0i);
            if _e225 {
                phi_368_ = type_8(0u, 4u);
                loop {
                    let _e227 = phi_368_;
                    if (_e227.member < _e227.member_1) {
                        phi_369_ = type_8((_e227.member + 1u), _e227.member_1);
                        phi_392_ = type_8(1u, _e227.member);
                    } else {
                        phi_369_ = _e227;
                        phi_392_ = type_8(0u, type_8().member_1);
                    }
                    let _e239 = phi_369_;
                    let _e241 = phi_392_;
                    let _e245 = (bitcast<i32>(_e241.member) != 0i);
                    if _e245 {
                        let _e252 = params.member.member_2.member[_e221.member_1][_e241.member_1];
                        words.member[((26u + (4u * _e221.member_1)) + _e241.member_1)] = _e252;
                    }
                    continue;
                    continuing {
                        phi_368_ = _e239;
                        break if !(_e245);
                    }
                }
            }
            continue;
            continuing {
                phi_334_ = _e219;
                break if !(_e225);
            }
        }
        let _e257 = params.member.member_2.member_1;
        words.member[58u] = _e257;
        let _e260 = params.member.member_2.member_2;
        words.member[59u] = _e260;
        let _e263 = params.member.member_2.member_3;
        words.member[60u] = _e263;
        let _e266 = params.member.member_2.member_4;
        words.member[61u] = _e266;
        let _e269 = paths.member[1u];
        local = type_13(array<f32, 4>(_e269.member[0], _e269.member[1], _e269.member[2], _e269.member[3]), array<f32, 4>(_e269.member_1[0], _e269.member_1[1], _e269.member_1[2], _e269.member_1[3]));
        let _e284 = leaves.member[1u];
        local_1 = type_14(array<u32, 3>(_e284.member[0], _e284.member[1], _e284.member[2]), _e284.member_1);
        let _e293 = touches.member[1u];
        let _e296 = pairs.member[1u].member;
        let _e298 = pairs.member[1u].member_1;
        phi_499_ = type_8(0u, 4u);
        loop {
            let _e300 = phi_499_;
            if (_e300.member < _e300.member_1) {
                phi_500_ = type_8((_e300.member + 1u), _e300.member_1);
                phi_523_ = type_8(1u, _e300.member);
            } else {
                phi_500_ = _e300;
                phi_523_ = type_8(0u, type_8().member_1);
            }
            let _e312 = phi_500_;
            let _e314 = phi_523_;
            let _e318 = (bitcast<i32>(_e314.member) != 0i);
            if _e318 {
                let _e322 = local.member[_e314.member_1];
                words.member[(62u + _e314.member_1)] = bitcast<u32>(_e322);
                let _e328 = local.member_1[_e314.member_1];
                words.member[(66u + _e314.member_1)] = bitcast<u32>(_e328);
            }
            continue;
            continuing {
                phi_499_ = _e312;
                break if !(_e318);
            }
        }
        phi_558_ = type_8(0u, 3u);
        loop {
            let _e333 = phi_558_;
            if (_e333.member < _e333.member_1) {
                phi_559_ = type_8((_e333.member + 1u), _e333.member_1);
                phi_582_ = type_8(1u, _e333.member);
            } else {
                phi_559_ = _e333;
                phi_582_ = type_8(0u, type_8().member_1);
            }
            let _e345 = phi_559_;
            let _e347 = phi_582_;
            let _e351 = (bitcast<i32>(_e347.member) != 0i);
            if _e351 {
                let _e355 = local_1.member[_e347.member_1];
                words.member[(70u + _e347.member_1)] = _e355;
            }
            continue;
            continuing {
                phi_558_ = _e345;
                break if !(_e351);
            }
        }
        let _e359 = local_1.member_1;
        words.member[73u] = _e359;
        words.member[74u] = _e293.member;
        words.member[75u] = _e293.member_1;
        words.member[76u] = _e293.member_2;
        words.member[77u] = _e293.member_3;
        words.member[78u] = _e293.member_4[0];
        words.member[79u] = _e293.member_4[1];
        words.member[80u] = _e296;
        words.member[81u] = _e298;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_layout(@builtin(local_invocation_index) lane: u32) {
    function_(lane);
}
