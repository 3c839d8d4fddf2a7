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

struct type_10 {
    member: array<u32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: type_7,
    member_1: type_8,
    member_2: type_11,
}

struct type_14 {
    member: type_13,
}

@group(0) @binding(0) 
var<storage> params: type_14;
@group(0) @binding(1) 
var<storage, read_write> table: type_10;
var<workgroup> sums: array<u32, 512>;

fn function_(id_1: vec3<u32>, lane_1: u32) {
    var phi_77_: u32;
    var phi_80_: type_11;
    var phi_83_: u32;
    var phi_81_: type_11;
    var phi_106_: type_11;
    var phi_132_: u32;
    var phi_149_: u32;
    var phi_166_: u32;
    var phi_183_: u32;
    var phi_190_: type_11;
    var phi_193_: u32;
    var phi_195_: u32;
    var phi_197_: u32;
    var phi_194_: u32;
    var phi_191_: type_11;
    var phi_220_: type_11;
    var phi_236_: u32;
    var phi_196_: u32;
    var phi_198_: u32;
    var local: u32;
    var phi_84_: u32;
    var local_1: u32;
    var id_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    lane_2 = lane_1;
    let _e17 = id_2;
    let _e18 = lane_2;
    let _e23 = params.member.member_2.member_1;
    let _e25 = (_e17.x * _e23);
    let _e26 = (_e23 / 1024u);
    if ((_e23 % 1024u) > 0u) {
        phi_77_ = (_e26 + 1u);
    } else {
        phi_77_ = _e26;
    }
    let _e31 = phi_77_;
    phi_80_ = type_11(0u, _e31);
    phi_83_ = 0u;
    loop {
        let _e34 = phi_80_;
        let _e36 = phi_83_;
        local_1 = _e36;
        if (_e34.member < _e34.member_1) {
            phi_81_ = type_11((_e34.member + 1u), _e34.member_1);
            phi_106_ = type_11(1u, _e34.member);
        } else {
            phi_81_ = _e34;
            phi_106_ = type_11(0u, type_11().member_1);
        }
        let _e48 = phi_81_;
        let _e50 = phi_106_;
        let _e54 = (bitcast<i32>(_e50.member) != 0i);
        if _e54 {
            let _e57 = ((_e50.member_1 * 1024u) + (4u * _e18));
            if (_e57 < _e23) {
                let _e61 = table.member[(_e25 + _e57)];
                phi_132_ = _e61;
            } else {
                phi_132_ = 0u;
            }
            let _e63 = phi_132_;
            let _e64 = (_e57 + 1u);
            if (_e64 < _e23) {
                let _e68 = table.member[(_e25 + _e64)];
                phi_149_ = _e68;
            } else {
                phi_149_ = 0u;
            }
            let _e70 = phi_149_;
            let _e71 = (_e57 + 2u);
            if (_e71 < _e23) {
                let _e75 = table.member[(_e25 + _e71)];
                phi_166_ = _e75;
            } else {
                phi_166_ = 0u;
            }
            let _e77 = phi_166_;
            let _e78 = (_e57 + 3u);
            if (_e78 < _e23) {
                let _e82 = table.member[(_e25 + _e78)];
                phi_183_ = _e82;
            } else {
                phi_183_ = 0u;
            }
            let _e84 = phi_183_;
            let _e87 = (((_e63 + _e70) + _e77) + _e84);
            sums[_e18] = _e87;
            phi_190_ = type_11(0u, 8u);
            phi_193_ = 0u;
            phi_195_ = 1u;
            phi_197_ = _e87;
            phi_194_ = 256u;
            loop {
                let _e90 = phi_190_;
                let _e92 = phi_193_;
                let _e94 = phi_195_;
                let _e96 = phi_197_;
                let _e98 = phi_194_;
                local = _e96;
                if (_e90.member < _e90.member_1) {
                    phi_191_ = type_11((_e90.member + 1u), _e90.member_1);
                    phi_220_ = type_11(1u, _e90.member);
                } else {
                    phi_191_ = _e90;
                    phi_220_ = type_11(0u, type_11().member_1);
                }
                let _e110 = phi_191_;
                let _e112 = phi_220_;
                let _e115 = (bitcast<i32>(_e112.member) != 0i);
                if _e115 {
                    workgroupBarrier();
                    if (_e18 >= _e94) {
                        let _e120 = sums[((_e92 + _e18) - _e94)];
                        phi_236_ = (_e96 + _e120);
                    } else {
                        phi_236_ = _e96;
                    }
                    let _e123 = phi_236_;
                    sums[(_e98 + _e18)] = _e123;
                    phi_196_ = (_e94 * 2u);
                    phi_198_ = _e123;
                } else {
                    phi_196_ = u32();
                    phi_198_ = u32();
                }
                let _e128 = phi_196_;
                let _e130 = phi_198_;
                continue;
                continuing {
                    phi_190_ = _e110;
                    phi_193_ = _e98;
                    phi_195_ = _e128;
                    phi_197_ = _e130;
                    phi_194_ = _e92;
                    break if !(_e115);
                }
            }
            workgroupBarrier();
            let _e133 = local;
            let _e135 = ((_e36 + _e133) - _e87);
            if (_e57 < _e23) {
                table.member[(_e25 + _e57)] = _e135;
            }
            let _e139 = (_e135 + _e63);
            if ((_e57 + 1u) < _e23) {
                table.member[((_e25 + _e57) + 1u)] = _e139;
            }
            let _e145 = (_e139 + _e70);
            if ((_e57 + 2u) < _e23) {
                table.member[((_e25 + _e57) + 2u)] = _e145;
            }
            if ((_e57 + 3u) < _e23) {
                table.member[((_e25 + _e57) + 3u)] = (_e145 + _e77);
            }
            let _e158 = sums[255u];
            workgroupBarrier();
            phi_84_ = (_e36 + _e158);
        } else {
            phi_84_ = u32();
        }
        let _e161 = phi_84_;
        continue;
        continuing {
            phi_80_ = _e48;
            phi_83_ = _e161;
            break if !(_e54);
        }
    }
    if (_e18 == 0u) {
        let _e169 = local_1;
        table.member[((256u * _e23) + _e17.x)] = _e169;
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn sort_scan(@builtin(workgroup_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, lane);
}
