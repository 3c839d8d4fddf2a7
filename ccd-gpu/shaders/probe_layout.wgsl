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
    member_18: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_7,
}

struct type_13 {
    member: array<u32>,
}

struct type_15 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_18 {
    member: array<type_15>,
}

struct type_26 {
    member: u32,
    member_1: u32,
}

struct type_31 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_34 {
    member: array<type_31>,
}

struct type_40 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_43 {
    member: array<type_40>,
}

struct type_47 {
    member: array<type_26>,
}

var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_34;
@group(0) @binding(2) 
var<storage> leaves: type_18;
@group(0) @binding(3) 
var<storage> touches: type_43;
@group(0) @binding(4) 
var<storage> pairs: type_47;
@group(0) @binding(5) 
var<storage, read_write> out: type_13;

fn function_() {
    var local: type_31;
    var local_1: type_15;
    var phi_116_: type_26;
    var phi_117_: type_26;
    var phi_140_: type_26;
    var phi_163_: type_26;
    var phi_164_: type_26;
    var phi_187_: type_26;
    var phi_278_: type_26;
    var phi_279_: type_26;
    var phi_302_: type_26;
    var phi_312_: type_26;
    var phi_313_: type_26;
    var phi_336_: type_26;
    var phi_428_: type_26;
    var phi_429_: type_26;
    var phi_452_: type_26;
    var phi_487_: type_26;
    var phi_488_: type_26;
    var phi_511_: type_26;

    let _e51 = lane_1;
    if (_e51 == 0u) {
        phi_116_ = type_26(0u, 3u);
        loop {
            let _e60 = phi_116_;
            if (_e60.member < _e60.member_1) {
                phi_117_ = type_26((_e60.member + 1u), _e60.member_1);
                phi_140_ = type_26(1u, _e60.member);
            } else {
                phi_117_ = _e60;
                phi_140_ = type_26(0u, type_26().member_1);
            }
            let _e74 = phi_117_;
            let _e76 = phi_140_;
            let _e80 = (bitcast<i32>(_e76.member) != 0i);
            if _e80 {
                if (_e76.member_1 < 3u) {
                } else {
                    return;
                }
                let _e84 = params.member.member[_e76.member_1];
                out.member[_e76.member_1] = _e84;
            }
            continue;
            continuing {
                phi_116_ = _e74;
                break if !(_e80);
            }
        }
        let _e88 = params.member.member_1;
        out.member[3u] = _e88;
        phi_163_ = type_26(0u, 4u);
        loop {
            let _e91 = phi_163_;
            if (_e91.member < _e91.member_1) {
                phi_164_ = type_26((_e91.member + 1u), _e91.member_1);
                phi_187_ = type_26(1u, _e91.member);
            } else {
                phi_164_ = _e91;
                phi_187_ = type_26(0u, type_26().member_1);
            }
            let _e105 = phi_164_;
            let _e107 = phi_187_;
            let _e111 = (bitcast<i32>(_e107.member) != 0i);
            if _e111 {
                if (_e107.member_1 < 4u) {
                } else {
                    return;
                }
                let _e116 = params.member.member_2[_e107.member_1];
                out.member[(4u + _e107.member_1)] = _e116;
            }
            continue;
            continuing {
                phi_163_ = _e105;
                break if !(_e111);
            }
        }
        let _e120 = params.member.member_3;
        out.member[8u] = bitcast<u32>(_e120);
        let _e124 = params.member.member_4;
        out.member[9u] = bitcast<u32>(_e124);
        let _e128 = params.member.member_5;
        out.member[10u] = bitcast<u32>(_e128);
        let _e132 = params.member.member_6;
        out.member[11u] = bitcast<u32>(_e132);
        let _e137 = params.member.member_7[0u];
        out.member[12u] = _e137;
        let _e141 = params.member.member_7[1u];
        out.member[13u] = _e141;
        let _e144 = params.member.member_8;
        out.member[14u] = _e144;
        let _e147 = params.member.member_9;
        out.member[15u] = _e147;
        let _e150 = params.member.member_10;
        out.member[16u] = _e150;
        let _e153 = params.member.member_11;
        out.member[17u] = _e153;
        let _e156 = params.member.member_12;
        out.member[18u] = _e156;
        let _e159 = params.member.member_13;
        out.member[19u] = _e159;
        let _e162 = params.member.member_14;
        out.member[20u] = _e162;
        let _e165 = params.member.member_15;
        out.member[21u] = _e165;
        let _e168 = params.member.member_16;
        out.member[22u] = _e168;
        let _e171 = params.member.member_17;
        out.member[23u] = _e171;
        phi_278_ = type_26(0u, 8u);
        loop {
            let _e174 = phi_278_;
            if (_e174.member < _e174.member_1) {
                phi_279_ = type_26((_e174.member + 1u), _e174.member_1);
                phi_302_ = type_26(1u, _e174.member);
            } else {
                phi_279_ = _e174;
                phi_302_ = type_26(0u, type_26().member_1);
            }
            let _e188 = phi_279_;
            let _e190 = phi_302_;
            let _e194 = (bitcast<i32>(_e190.member) != 0i);
            if _e194 {
                phi_312_ = type_26(0u, 4u);
                loop {
                    let _e196 = phi_312_;
                    if (_e196.member < _e196.member_1) {
                        phi_313_ = type_26((_e196.member + 1u), _e196.member_1);
                        phi_336_ = type_26(1u, _e196.member);
                    } else {
                        phi_313_ = _e196;
                        phi_336_ = type_26(0u, type_26().member_1);
                    }
                    let _e210 = phi_313_;
                    let _e212 = phi_336_;
                    let _e216 = (bitcast<i32>(_e212.member) != 0i);
                    if _e216 {
                        if (_e190.member_1 < 8u) {
                        } else {
                            return;
                        }
                        if (_e212.member_1 < 4u) {
                        } else {
                            return;
                        }
                        let _e225 = params.member.member_18[_e190.member_1][_e212.member_1];
                        out.member[((24u + (4u * _e190.member_1)) + _e212.member_1)] = _e225;
                    }
                    continue;
                    continuing {
                        phi_312_ = _e210;
                        break if !(_e216);
                    }
                }
            }
            continue;
            continuing {
                phi_278_ = _e188;
                break if !(_e194);
            }
        }
        let _e230 = paths.member[1u];
        local = type_31(array<f32, 4>(_e230.member[0], _e230.member[1], _e230.member[2], _e230.member[3]), array<f32, 4>(_e230.member_1[0], _e230.member_1[1], _e230.member_1[2], _e230.member_1[3]));
        let _e245 = leaves.member[1u];
        local_1 = type_15(array<u32, 3>(_e245.member[0], _e245.member[1], _e245.member[2]), _e245.member_1);
        let _e254 = touches.member[1u];
        let _e257 = pairs.member[1u].member;
        let _e259 = pairs.member[1u].member_1;
        phi_428_ = type_26(0u, 4u);
        loop {
            let _e261 = phi_428_;
            if (_e261.member < _e261.member_1) {
                phi_429_ = type_26((_e261.member + 1u), _e261.member_1);
                phi_452_ = type_26(1u, _e261.member);
            } else {
                phi_429_ = _e261;
                phi_452_ = type_26(0u, type_26().member_1);
            }
            let _e275 = phi_429_;
            let _e277 = phi_452_;
            let _e281 = (bitcast<i32>(_e277.member) != 0i);
            if _e281 {
                if (_e277.member_1 < 4u) {
                } else {
                    return;
                }
                let _e286 = local.member[_e277.member_1];
                out.member[(56u + _e277.member_1)] = bitcast<u32>(_e286);
                if (_e277.member_1 < 4u) {
                } else {
                    return;
                }
                let _e293 = local.member_1[_e277.member_1];
                out.member[(60u + _e277.member_1)] = bitcast<u32>(_e293);
            }
            continue;
            continuing {
                phi_428_ = _e275;
                break if !(_e281);
            }
        }
        phi_487_ = type_26(0u, 3u);
        loop {
            let _e298 = phi_487_;
            if (_e298.member < _e298.member_1) {
                phi_488_ = type_26((_e298.member + 1u), _e298.member_1);
                phi_511_ = type_26(1u, _e298.member);
            } else {
                phi_488_ = _e298;
                phi_511_ = type_26(0u, type_26().member_1);
            }
            let _e312 = phi_488_;
            let _e314 = phi_511_;
            let _e318 = (bitcast<i32>(_e314.member) != 0i);
            if _e318 {
                if (_e314.member_1 < 3u) {
                } else {
                    return;
                }
                let _e323 = local_1.member[_e314.member_1];
                out.member[(64u + _e314.member_1)] = _e323;
            }
            continue;
            continuing {
                phi_487_ = _e312;
                break if !(_e318);
            }
        }
        let _e327 = local_1.member_1;
        out.member[67u] = _e327;
        out.member[68u] = _e254.member;
        out.member[69u] = _e254.member_1;
        out.member[70u] = _e254.member_2;
        out.member[71u] = _e254.member_3;
        out.member[72u] = _e254.member_4[0];
        out.member[73u] = _e254.member_4[1];
        out.member[74u] = _e257;
        out.member[75u] = _e259;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn probe_layout(@builtin(local_invocation_index) lane: u32) {
    lane_1 = lane;
    function_();
}
